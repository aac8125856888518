// SPDX-License-Identifier: Apache-2.0
// Tests that a folder dropped on the window becomes a plate, as one step that can be taken back.
#include <QAbstractButton>
#include <QLabel>
#include <QToolButton>
#include <QtTest>

#include "model/edit/look.h"
#include "model/look/drawing_styles.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/focus/focus_context.h"
#include "widgets/structure_tree/structure_tree.h"

namespace sline::test {

class OpeningLookWindowTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static bool wait(WindowFixture& f) {
    return QTest::qWaitFor([&f] { return !f.session.busy() && !f.window.focus().busy(); }, 60000) &&
           f.settled();
  }
  static float gammaOf(WindowFixture& f, const char* name) {
    return f.session.scene().resolve(f.session.scene().named(name).front()).gamma.value();
  }
  static void trigger(WindowFixture& f, const char* action) {
    f.control<QAction>(action).trigger();
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void aFolderBecomesAPlate() {
    WindowFixture f;
    f.window.preferences().set("picture/openingLook", "auto");
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
    QCOMPARE(f.session.history().undoText(), QString("Opening look"));
    QVERIFY2(!f.session.modified(), "what was chosen is no unsaved work");
    QVERIFY(f.window.focus().state().analysis);
    f.session.undo();
    QCOMPARE(gammaOf(f, "left kidney"), 2.0f);
    f.session.redo();
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
  }
  /// Whatever room panels take while the look is chosen, all of the subject is in the picture.
  void framedForThePictureAsItIs() {
    WindowFixture f;
    f.window.preferences().set("picture/openingLook", "auto");
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(QTest::qWaitFor([&f] { return f.window.focus().busy(); }, 60000));
    const float before = float(f.viewport().width()) / float(f.viewport().height());
    f.window.resize(f.window.width() - 350, f.window.height());
    QVERIFY(wait(f));
    const float aspect = float(f.viewport().width()) / float(f.viewport().height());
    QVERIFY2(aspect < 0.8f * before, "the picture has become narrower");
    model::Box box;
    for (const model::NodeId id : f.window.focus().state().targets)
      box.add(f.session.scene().visibleBounds(id));
    const model::Camera& camera = f.viewport().camera();
    const glm::mat4 toPicture =
        model::projectionMatrix(camera, box, aspect) * model::viewMatrix(camera);
    for (const glm::vec3& corner : box.corners()) {
      const glm::vec4 clip = toPicture * glm::vec4(corner, 1.0f);
      QVERIFY(std::abs(clip.x) < 0.98f * clip.w && std::abs(clip.y) < 0.98f * clip.w);
    }
  }
  /// A style chosen on the start page is the preference; what is opened next is drawn so at once.
  void inAStyleOfTheStartPage() {
    WindowFixture f;
    auto& woodcut = f.control<QAbstractButton>("startDrawing-woodcut");
    auto& plate = f.control<QAbstractButton>("startDrawing-auto");
    QVERIFY2(!woodcut.isChecked() && !plate.isChecked(), "plain");
    QVERIFY(!woodcut.accessibleName().isEmpty() && !woodcut.accessibleDescription().isEmpty());
    woodcut.click();
    QCOMPARE(f.window.preferences().choice("picture/openingLook"), QString("woodcut"));
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QCOMPARE(f.session.history().count(), 1);
    QCOMPARE(f.session.history().undoText(), QString("Opening look"));
    QVERIFY2(!f.session.modified(), "what was chosen is no unsaved work");
    QCOMPARE(gammaOf(f, "left kidney"), 3.0f);
    QVERIFY(f.session.scene().resolve(f.session.scene().named("left kidney").front()).inkColour ==
            Colour({0, 0, 0}));
    QCOMPARE(f.viewport().background(), render::Background::white);
    f.window.preferences().set("picture/openingLook", "lecture-hall");
    QVERIFY(f.control<QAbstractButton>("startDrawing-lecture-hall").isChecked());
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QCOMPARE(f.viewport().background(), render::Background::dark);
    plate.click();
    QCOMPARE(f.window.preferences().choice("picture/openingLook"), QString("auto"));
    QCOMPARE(f.window.preferences().choice("picture/background"), QString("white"));
  }
  void everyStyleIsOffered() {
    WindowFixture f;
    for (const model::DrawingStyle& style : model::drawingStyles()) {
      const QString id = style.styleOf ? QString::fromStdString(std::string(style.id)) : "auto";
      QVERIFY2(f.window.preferences().set("picture/openingLook", id), qPrintable(id));
      const auto& card =
          f.control<QAbstractButton>(qPrintable(QStringLiteral("startDrawing-") + id));
      QVERIFY2(card.isChecked(), qPrintable(id));
    }
  }
  void plainWhereWished() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QCOMPARE(gammaOf(f, "left kidney"), 2.0f);
    trigger(f, "plate");
    QVERIFY(wait(f));
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
    QVERIFY(f.session.modified());
  }
  void anotherSubject() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    trigger(f, "plate");
    QVERIFY(wait(f));
    const model::Scene first = f.session.scene();
    trigger(f, "anotherSubject");
    QVERIFY(wait(f));
    QVERIFY(!(f.session.scene() == first));
    const auto subjects = model::subjectsOf(first).size();
    for (std::size_t i = 1; i < subjects; ++i) {
      trigger(f, "anotherSubject");
      QVERIFY(wait(f));
    }
    QCOMPARE(f.session.scene(), first);
  }
  /// Three small plates are offered; the keyboard chooses the second.
  void subjectsToChooseFrom() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    trigger(f, "plate");
    QVERIFY(wait(f));
    trigger(f, "subjects");
    auto* popup = f.window.findChild<QWidget*>(QStringLiteral("subjectPopup"));
    QVERIFY(popup);
    const auto button = [popup](int i) {
      return popup->findChild<QToolButton*>(QStringLiteral("subject%1").arg(i));
    };
    QVERIFY(QTest::qWaitFor([&] { return button(2)->isVisible(); }, 60000));
    const auto drawn = [&](int i) {
      const QImage image = button(i)->icon().pixmap(button(i)->iconSize()).toImage();
      const QRgb corner = image.pixel(0, 0);
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          if (image.pixel(x, y) != corner)
            return true;
      return false;
    };
    for (int i = 0; i < 3; ++i) {
      QVERIFY(QTest::qWaitFor([&] { return drawn(i); }, 60000));
      QVERIFY(!button(i)->text().isEmpty());
    }
    const model::Scene before = f.session.scene();
    QVERIFY(button(0)->hasFocus());
    QTest::keyClick(button(0), Qt::Key_Right);
    QVERIFY(button(1)->hasFocus());
    QTest::keyClick(button(1), Qt::Key_Return);
    QVERIFY(wait(f));
    QCOMPARE(f.window.focus().subject(), std::size_t(2));
    QVERIFY(!(f.session.scene() == before));
    QVERIFY(QTest::qWaitFor(
        [&] { return !f.window.findChild<QWidget*>(QStringLiteral("subjectPopup")); }, 5000));
    trigger(f, "subjects");
    popup = f.window.findChild<QWidget*>(QStringLiteral("subjectPopup"));
    QTest::keyClick(popup, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor(
        [&] { return !f.window.findChild<QWidget*>(QStringLiteral("subjectPopup")); }, 5000));
    QCOMPARE(f.window.focus().subject(), std::size_t(2));
  }
  /// The properties say why a structure is drawn as it is, until it is drawn otherwise by hand.
  void choicesAreExplained() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    QVERIFY(f.window.focus().explanation(kidney).isEmpty());
    trigger(f, "plate");
    QVERIFY(wait(f));
    QCOMPARE(f.window.focus().explanation(kidney), QString("in detail: it is the subject"));
    f.window.tree().showProperties({kidney});
    auto* text = f.window.findChild<QLabel*>(QStringLiteral("property-drawn"));
    QVERIFY(text && text->text() == f.window.focus().explanation(kidney));
    f.session.apply("by hand", model::withLook(f.session.scene(), {&kidney, 1},
                                               {.gamma = Gamma::clamped(1.0f)}));
    QCOMPARE(f.window.focus().explanation(kidney), QString("set by hand since"));
  }
  void whatIsChangedMeanwhileCounts() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    trigger(f, "plate");
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    f.session.apply("by hand", model::withLook(f.session.scene(), {&kidney, 1},
                                               {.gamma = Gamma::clamped(1.0f)}));
    QVERIFY(wait(f));
    QCOMPARE(gammaOf(f, "left kidney"), 1.0f);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::OpeningLookWindowTest)
#include "opening_look_window_test.moc"
