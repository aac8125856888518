// SPDX-License-Identifier: Apache-2.0
// Tests drawing styles in the window: small pictures of the scene, and what a choice does.
#include <QToolButton>
#include <QtTest>
#include <array>

#include "model/edit/look.h"
#include "model/look/drawing_styles.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/support/suite.h"
#include "widgets/gamma/drawing_panel.h"

using namespace sline;
using namespace sline::test;

namespace {

struct DrawingFixture : GammaPanelFixture {
  widgets::DrawingPanel& panel() { return *window.findChild<widgets::DrawingPanel*>(); }
  QToolButton& button(const char* id) {
    return control<QToolButton>(qPrintable(QStringLiteral("drawing ") + QLatin1String(id)));
  }
  void unfoldDrawings() {
    click(control<QToolButton>("drawings"));
    QCoreApplication::processEvents();
  }
  /// Chooses the style with the mouse; returns false where no step follows.
  bool choose(const char* id) {
    const int before = steps();
    const int at = session.history().index();
    click(button(id));
    return QTest::qWaitFor([&] { return steps() != before || session.history().index() != at; },
                           minute);
  }
};

}  // namespace

class DrawingStylesWindowTest : public QObject {
  Q_OBJECT
 private slots:
  void textsAreTheModels() {
    const auto texts = widgets::drawingTexts();
    QCOMPARE(texts.size(), model::drawingStyles().size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      QCOMPARE(texts[i].name.toStdString(), std::string(model::drawingStyles()[i].name));
      QCOMPARE(texts[i].description.toStdString(),
               std::string(model::drawingStyles()[i].description));
    }
  }
  void picturesAppear() {
    DrawingFixture f;
    QVERIFY(!f.panel().hasPicture(0));
    f.unfoldDrawings();
    const auto all = [&] {
      for (int i = 0; i < int(model::drawingStyles().size()); ++i)
        if (!f.panel().hasPicture(i))
          return false;
      return true;
    };
    QVERIFY(QTest::qWaitFor(all, minute));
    QVERIFY(f.button("lecture-hall").height() > 62);
    const QImage dark = f.button("lecture-hall").icon().pixmap(76, 62).toImage();
    const QImage paper = f.button("pencil").icon().pixmap(76, 62).toImage();
    QVERIFY(dark.pixelColor(dark.width() / 2, 1).lightness() < 60);
    QVERIFY(paper.pixelColor(paper.width() / 2, 1).lightness() > 200);
  }
  void aClickIsOneStep() {
    DrawingFixture f;
    f.unfoldDrawings();
    const model::Scene before = f.session.scene();
    f.window.preferences().set("picture/background", "paper");
    const render::Background ground = f.viewport().background();
    QCOMPARE(ground, render::Background::paper);
    const int steps = f.steps();
    QVERIFY(f.choose("lecture-hall"));
    QCOMPARE(f.steps(), steps + 1);
    QCOMPARE(f.session.history().undoText(), QStringLiteral("Lecture Hall"));
    QTRY_COMPARE(f.viewport().background(), render::Background::dark);
    const model::Scene first = f.session.scene();
    QVERIFY(!(first == before));
    // The next style starts from what was there before this one: colours are what they were.
    QVERIFY(f.choose("even-pen"));
    QCOMPARE(f.steps(), steps + 2);
    QTRY_COMPARE(f.viewport().background(), render::Background::white);
    QCOMPARE(f.session.scene().resolve(f.named("bladder")).colour,
             before.resolve(f.named("bladder")).colour);
    QCOMPARE(f.session.scene().resolve(f.named("bladder")).lineVariation, 0.0f);
    // Undo brings back the background with the style, and so does Redo.
    const auto press = [&f](Qt::KeyboardModifiers keys) {
      QTest::keyClick(&f.viewport(), Qt::Key_Z, keys);
    };
    press(Qt::ControlModifier);
    QVERIFY(f.session.scene() == first);
    QCOMPARE(f.viewport().background(), render::Background::dark);
    press(Qt::ControlModifier);
    QVERIFY(f.session.scene() == before);
    QCOMPARE(f.viewport().background(), ground);
    press(Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(f.viewport().background(), render::Background::dark);
    // One that was chosen since stays.
    f.window.preferences().set("picture/background", "white");
    press(Qt::ControlModifier);
    QCOMPARE(f.viewport().background(), render::Background::white);
  }
  /// Styles of few colours give colours back to the next one, also where something else was done in
  /// between, where steps were taken back, and where the scene was opened in one.
  void coloursComeBack() {
    DrawingFixture f;
    f.unfoldDrawings();
    const auto colour = [&f](const char* name) {
      return f.session.scene().resolve(f.named(name)).colour;
    };
    const auto hide = [&f](const char* name) {
      const model::NodeId id = f.named(name);
      return f.session.apply(
          "Hide", model::withLook(f.session.scene(), std::array{id}, {.visible = false}));
    };
    const Colour white{255, 255, 255};
    const Colour bladder = colour("bladder");
    const Colour kidney = colour("left kidney");
    QVERIFY(bladder != white && kidney != white);
    QVERIFY(f.choose("woodcut"));
    QVERIFY(colour("bladder") == white && colour("left kidney") == white);
    QVERIFY(hide("aorta"));
    QVERIFY(f.choose("pencil"));
    QCOMPARE(colour("bladder"), bladder);
    QCOMPARE(colour("left kidney"), kidney);
    QVERIFY(f.choose("lecture-hall"));
    QVERIFY(colour("bladder") != bladder || colour("left kidney") != kidney);
    const Colour own{12, 200, 34};
    const model::NodeId id = f.named("bladder");
    QVERIFY(f.session.apply("Colour",
                            model::withLook(f.session.scene(), std::array{id}, {.colour = own})));
    f.control<QAction>("plate").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(colour("left kidney"), kidney, minute);
    QCOMPARE(colour("bladder"), own);  // by hand
    while (f.session.history().undoText() != "Woodcut")
      f.session.undo();
    QCOMPARE(colour("bladder"), white);
    QVERIFY(hide("left kidney"));
    QVERIFY(f.choose("even-pen"));
    QCOMPARE(colour("bladder"), bladder);
  }
  void coloursComeBackFromTheOpening() {
    DrawingFixture plain;
    const Colour bladder = plain.session.scene().resolve(plain.named("bladder")).colour;
    plain.window.close();
    WindowFixture f;
    f.window.preferences().set("picture/openingLook", "woodcut");
    const QTemporaryDir body;
    writeBody(body.path());
    const auto colour = [&f] {
      return f.session.scene().resolve(f.session.scene().named("bladder").front()).colour;
    };
    QVERIFY(f.drop(body.path()));
    QTRY_COMPARE_WITH_TIMEOUT(f.session.history().count(), 1, minute);
    QVERIFY(f.settled());
    QVERIFY(colour() == Colour({255, 255, 255}));
    f.control<QAction>("plate").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(f.session.history().count(), 2, minute);
    QCOMPARE(colour(), bladder);
  }
  void coloursComeBackFromAFile() {
    DrawingFixture f;
    f.unfoldDrawings();
    const Colour bladder = f.session.scene().resolve(f.named("bladder")).colour;
    QVERIFY(f.choose("woodcut"));
    const QTemporaryDir folder;
    const QString saved = folder.filePath("woodcut.sline");
    QVERIFY(model::writeSceneFile(saved.toStdString(), {f.session.scene(), {}, {}, 0}).ok());
    f.window.close();
    WindowFixture g;
    QVERIFY(g.drop(saved) && g.settled());
    const auto colour = [&g] {
      return g.session.scene().resolve(g.session.scene().named("bladder").front()).colour;
    };
    QVERIFY(colour() == Colour({255, 255, 255}));
    g.control<QAction>("plate").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(colour(), bladder, minute);
    g.session.undo();
    QVERIFY(colour() == Colour({255, 255, 255}));
  }
  void byKeys() {
    DrawingFixture f;
    f.unfoldDrawings();
    QToolButton& woodcut = f.button("woodcut");
    QVERIFY(woodcut.focusPolicy() & Qt::TabFocus);
    QVERIFY(!woodcut.toolTip().isEmpty());
    const int steps = f.steps();
    QTest::keyClick(&woodcut, Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return f.steps() == steps + 1; }, minute));
    QCOMPARE(f.session.history().undoText(), QStringLiteral("Woodcut"));
  }
};

SLINE_TEST_WITH_WIDGETS(DrawingStylesWindowTest)
#include "drawing_styles_window_test.moc"
