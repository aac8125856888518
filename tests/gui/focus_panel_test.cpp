// SPDX-License-Identifier: Apache-2.0
// Tests focus and context by hand: one key, one slider, roles corrected, every change one step.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

#include "model/edit/visibility.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/focus/amount_slider.h"
#include "widgets/focus/focus_context.h"

namespace sline::test {

class FocusPanelTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static model::NodeId named(WindowFixture& f, const char* name) {
    return f.session.scene().named(name).front();
  }
  bool openAndFocus(WindowFixture& f, const char* name = "left kidney") {
    if (!f.drop(m_body.path()) || !f.settled())
      return false;
    f.session.select({named(f, name)});
    QTest::keyClick(&f.window, Qt::Key_F);
    return f.settled();
  }
  static widgets::AmountSlider& slider(WindowFixture& f) {
    return f.control<widgets::AmountSlider>("contextAmount");
  }
  static QPoint at(widgets::AmountSlider& slider, double share) {
    return {int(8 + share * (slider.width() - 16)), slider.height() / 2};
  }
  static QTreeWidgetItem* row(WindowFixture& f, const QString& name) {
    const auto found =
        f.control<QTreeWidget>("focusRoles").findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? nullptr : found.front();
  }
  static bool shown(WindowFixture& f, const char* name) {
    return f.session.scene().resolve(named(f, name)).visible;
  }
  static float gammaOf(WindowFixture& f, const char* name) {
    return f.session.scene().resolve(named(f, name)).gamma.value();
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void oneKeyIsOneStep_data() {
    QTest::addColumn<QString>("way");
    QTest::newRow("key") << "key";
    QTest::newRow("button of the panel") << "focusOnSelection";
    QTest::newRow("button under Γ") << "focusButton";
  }
  void oneKeyIsOneStep() {
    QFETCH(QString, way);
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const model::Scene before = f.session.scene();
    QVERIFY(!f.control<QPushButton>("focusOnSelection").isEnabled());
    QVERIFY(!slider(f).isEnabled());
    f.session.select({named(f, "left kidney")});
    if (way == QLatin1String("key"))
      QTest::keyClick(&f.window, Qt::Key_F);
    else
      QTest::mouseClick(&f.control<QPushButton>(way.toLatin1()), Qt::LeftButton);
    QVERIFY(f.window.focus().busy());
    QVERIFY(f.settled());
    QCOMPARE(f.session.history().count(), 1);
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
    QVERIFY(gammaOf(f, "left renal vein") < 4.0f);
    QVERIFY(slider(f).isEnabled());
    QCOMPARE(f.control<QLabel>("focusTitle").text(), QStringLiteral("left kidney"));
    QVERIFY(row(f, QStringLiteral("bladder")));

    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == before);
    QVERIFY(!slider(f).isEnabled());
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(slider(f).isEnabled());
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
  }

  void aDragFollowsAndIsOneStep() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    const QImage half = f.picture();
    const model::Scene before = f.session.scene();
    widgets::AmountSlider& amount = slider(f);
    sendMouse(amount, QEvent::MouseButtonPress, at(amount, 0.5));
    for (const double share : {0.3, 0.1, 0.0})
      sendMouse(amount, QEvent::MouseMove, at(amount, share));
    QVERIFY(f.session.previewing());
    QVERIFY(!shown(f, "bladder") && shown(f, "left kidney"));
    sendMouse(amount, QEvent::MouseMove, at(amount, 1.0));
    QVERIFY(shown(f, "bladder"));
    QCOMPARE(f.session.history().count(), 1);
    sendMouse(amount, QEvent::MouseButtonRelease, at(amount, 1.0));
    QCOMPARE(f.session.history().count(), 2);
    QVERIFY(f.settled());
    QVERIFY(!difference(half, f.picture()).isEmpty());
    QCOMPARE(amount.value(), 100);
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene() == before);
    QCOMPARE(amount.value(), 50);
  }

  void escapeGivesADragUp() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    const model::Scene before = f.session.scene();
    widgets::AmountSlider& amount = slider(f);
    sendMouse(amount, QEvent::MouseButtonPress, at(amount, 0.9));
    QVERIFY(!(f.session.scene() == before));
    QTest::keyClick(&amount, Qt::Key_Escape);
    sendMouse(amount, QEvent::MouseButtonRelease, at(amount, 0.9));
    QVERIFY(f.session.scene() == before);
    QCOMPARE(f.session.history().count(), 1);
    QCOMPARE(amount.value(), 50);
  }

  void keysStep() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    widgets::AmountSlider& amount = slider(f);
    amount.setFocus();
    QTest::keyClick(&amount, Qt::Key_PageUp);
    QCOMPARE(f.window.focus().state().amount.value(), 0.6f);
    QTest::keyClick(&amount, Qt::Key_Home);
    QCOMPARE(f.window.focus().state().amount.value(), 0.0f);
    QVERIFY(!shown(f, "bladder"));
    QCOMPARE(f.session.history().count(), 2);  // keys in a row are one step
  }

  void rolesCanBeCorrected() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    auto& roles = f.control<QTreeWidget>("focusRoles");
    auto& role = f.control<QComboBox>("focusRole");
    QVERIFY(!role.isEnabled());
    QTreeWidgetItem* vein = row(f, QStringLiteral("left renal vein"));
    QVERIFY(vein && vein->parent());
    vein->parent()->setExpanded(true);
    QTest::mouseClick(roles.viewport(), Qt::LeftButton, {}, roles.visualItemRect(vein).center());
    QVERIFY(role.isEnabled());
    QVERIFY(!vein->toolTip(0).isEmpty());
    role.setFocus();
    while (role.currentIndex() > 0)
      QTest::keyClick(&role, Qt::Key_Up);  // in focus, too
    QVERIFY(gammaOf(f, "left renal vein") > 4.0f);
    const int corrections = f.session.history().count() - 1;
    QVERIFY(corrections > 0);
    // The amount does not change a corrected role.
    slider(f).setFocus();
    QTest::keyClick(&slider(f), Qt::Key_Home);
    QVERIFY(shown(f, "left renal vein") && !shown(f, "bladder"));
    for (int i = 0; i < 1 + corrections; ++i)
      QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(gammaOf(f, "left renal vein") < 4.0f);
  }

  void thisViewAndAllRound() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    QTest::keyClick(&f.window, Qt::Key_L);
    QTest::mouseClick(&f.control<QPushButton>("fromView"), Qt::LeftButton);
    QVERIFY(f.settled());
    QVERIFY(f.window.focus().state().analysis->camera);
    // Seen from the left the right kidney hides nothing of the left one.
    for (const model::Relation& relation : f.window.focus().state().analysis->relations)
      if (relation.structure == named(f, "right kidney"))
        QCOMPARE(relation.hides, 0.0f);
    const int steps = f.session.history().count();
    QTest::mouseClick(&f.control<QPushButton>("fromAround"), Qt::LeftButton);
    QVERIFY(f.settled());
    QVERIFY(!f.window.focus().state().analysis->camera);
    QVERIFY(f.session.history().count() >= steps);
  }

  void hiddenStaysHiddenUnlessWanted() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const model::NodeId aorta[] = {named(f, "aorta")};
    f.session.apply(QStringLiteral("hide"), model::withHidden(f.session.scene(), aorta));
    f.session.select({named(f, "left kidney")});
    QTest::keyClick(&f.window, Qt::Key_F);
    QVERIFY(f.settled());
    QVERIFY(!shown(f, "aorta"));
    auto& too = f.control<QCheckBox>("focusHiddenToo");
    QVERIFY(too.isVisible());
    QTest::mouseClick(&too, Qt::LeftButton, {}, {8, too.height() / 2});
    QTest::keyClick(&slider(f), Qt::Key_End);
    QVERIFY(shown(f, "aorta"));
  }

  /// Γ that a person dragged since stays when F is pressed again; it is marked, and one click gives
  /// it back.
  void whatWasSetByHandStays() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    slider(f).setFocus();
    QTest::keyClick(&slider(f), Qt::Key_End);
    auto& back = f.control<QPushButton>("focusGiveBack");
    QVERIFY(!back.isVisible());
    const float asFocus = gammaOf(f, "bladder");
    f.pullGamma(named(f, "bladder"), 5.0f);
    f.letGoOfGamma();
    const float hers = gammaOf(f, "bladder");
    QVERIFY(hers > 4.5f && hers != asFocus);
    QVERIFY(back.isVisible());
    QVERIFY(row(f, QStringLiteral("bladder – by hand")));
    f.session.select({named(f, "left kidney"), named(f, "aorta")});
    QTest::keyClick(&f.window, Qt::Key_F);
    QVERIFY(f.settled());
    QVERIFY(gammaOf(f, "aorta") > 4.0f);
    QCOMPARE(gammaOf(f, "bladder"), hers);
    QTreeWidgetItem* marked = row(f, QStringLiteral("bladder – by hand"));
    QVERIFY(marked && marked->toolTip(0).contains(QLatin1String("by hand")));
    QVERIFY(back.text().startsWith(QLatin1Char('1')));
    const int steps = f.session.history().count();
    QTest::mouseClick(&back, Qt::LeftButton);
    QCOMPARE(f.session.history().count(), steps + 1);
    QVERIFY(gammaOf(f, "bladder") < 4.0f);
    QVERIFY(!back.isVisible() && row(f, QStringLiteral("bladder")));
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(gammaOf(f, "bladder"), hers);
    QVERIFY(back.isVisible());
  }

  /// A scene file brings back what was in focus and how much context there was.
  void theSceneFileHasTheFocus() {
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("body.sline").toStdString();
    {
      WindowFixture f;
      QVERIFY(openAndFocus(f));
      slider(f).setFocus();
      QTest::keyClick(&slider(f), Qt::Key_PageUp);
      QVERIFY(model::writeSceneFile(file, {.scene = f.session.scene()}).ok());
    }
    WindowFixture f;
    f.session.openPaths({file});
    QVERIFY(QTest::qWaitFor([&f] { return !f.session.scene().nodes().empty(); }));
    QVERIFY(f.settled());
    QCOMPARE(f.control<QLabel>("focusTitle").text(), QStringLiteral("left kidney"));
    QCOMPARE(slider(f).value(), 60);
    QVERIFY(slider(f).isEnabled() && row(f, QStringLiteral("bladder")));
    QVERIFY(!f.session.modified());
    slider(f).setFocus();
    QTest::keyClick(&slider(f), Qt::Key_Home);
    QVERIFY(!shown(f, "bladder") && shown(f, "left kidney"));
  }

  /// Each view has its own focus and amount.
  void viewsHaveTheirOwn() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    f.control<QAction>("addView").trigger();
    f.session.select({named(f, "bladder")});
    QTest::keyClick(&f.window, Qt::Key_F);
    QVERIFY(f.settled());
    slider(f).setFocus();
    QTest::keyClick(&slider(f), Qt::Key_End);
    f.control<QAction>("addView").trigger();
    const auto go = [&f](int index) {
      auto& cards = f.control<QListView>("viewRow");
      QTest::mouseClick(cards.viewport(), Qt::LeftButton, {},
                        cards.visualRect(cards.model()->index(index, 0)).center());
      return f.settled();
    };
    QVERIFY(go(0));
    QTRY_COMPARE(f.control<QLabel>("focusTitle").text(), QStringLiteral("left kidney"));
    QCOMPARE(slider(f).value(), 50);
    QVERIFY(go(1));
    QTRY_COMPARE(f.control<QLabel>("focusTitle").text(), QStringLiteral("bladder"));
    QCOMPARE(slider(f).value(), 100);
    QVERIFY(gammaOf(f, "bladder") > 4.0f);
  }

  void anotherDocumentBeginsAnew() {
    WindowFixture f;
    QVERIFY(openAndFocus(f));
    f.session.openPaths({m_body.path().toStdString()});
    QVERIFY(f.settled());
    QVERIFY(!f.window.focus().state().analysis);
    QVERIFY(!slider(f).isEnabled());
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.window.focus().state().analysis);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::FocusPanelTest)
#include "focus_panel_test.moc"
