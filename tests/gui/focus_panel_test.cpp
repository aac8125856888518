// SPDX-License-Identifier: Apache-2.0
// Tests focus and context by hand: one key, one slider, roles corrected, every change one step.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest>

#include "model/edit/visibility.h"
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
    QVERIFY(f.window.focus().state().analysis->fromCamera);
    // Seen from the left the right kidney hides nothing of the left one.
    for (const model::Relation& relation : f.window.focus().state().analysis->relations)
      if (relation.structure == named(f, "right kidney"))
        QCOMPARE(relation.hides, 0.0f);
    const int steps = f.session.history().count();
    QTest::mouseClick(&f.control<QPushButton>("fromAround"), Qt::LeftButton);
    QVERIFY(f.settled());
    QVERIFY(!f.window.focus().state().analysis->fromCamera);
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
