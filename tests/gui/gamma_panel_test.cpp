// SPDX-License-Identifier: Apache-2.0
// Tests the panel beside the picture by mouse and keys on the real window: Γ with its live stages.
#include <QtTest>
#include <cmath>

#include "model/edit/look.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

double ink(const QImage& picture) {
  double sum = 0.0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      sum += 255.0 - qGray(picture.pixel(x, y));
  return sum / (picture.width() * picture.height());
}

}  // namespace

class GammaPanelTest : public QObject {
  Q_OBJECT
 private slots:
  void keysStep();
  void escapeTakesADragBack();
  void aStageIsOneClick();
  void stagesAreLive();
  void picturesComeFirst();
  void severalValuesAreARange();
  void aDragDrawsOneLayer();
};

void GammaPanelTest::keysStep() {
  GammaPanelFixture f;
  f.session.select({f.named("bladder")});
  f.slider().setFocus();
  const auto press = [&](Qt::Key key, float gamma) {
    QTest::keyClick(&f.slider(), key);
    QVERIFY2(std::abs(f.gammaOf("bladder") - gamma) < 1e-4f,
             qPrintable(QString::number(f.gammaOf("bladder"))));
  };
  press(Qt::Key_End, 5.0f);
  press(Qt::Key_Down, 4.95f);
  press(Qt::Key_Left, 4.9f);
  press(Qt::Key_PageDown, 3.9f);
  press(Qt::Key_Right, 3.95f);
  press(Qt::Key_PageUp, 4.95f);
  press(Qt::Key_Home, 0.0f);
  press(Qt::Key_Up, 0.05f);
  QCOMPARE(f.steps(), 1);  // keys in a row are one step
  f.session.undo();
  // The number is written as the locale does.
  f.number().setFocus();
  f.number().selectAll();
  QTest::keyClicks(&f.number(), QLocale().toString(3.25, 'f', 2));
  QTest::keyClick(&f.number(), Qt::Key_Return);
  QCOMPARE(f.gammaOf("bladder"), 3.25f);
}

void GammaPanelTest::escapeTakesADragBack() {
  GammaPanelFixture f;
  f.session.select({f.named("bladder")});
  const model::Scene before = f.session.scene();
  const int steps = f.steps();
  sendMouse(f.slider(), QEvent::MouseButtonPress, f.slider().pointOf(Gamma::clamped(2.0f)));
  sendMouse(f.slider(), QEvent::MouseMove, f.slider().pointOf(Gamma::clamped(4.0f)));
  QVERIFY(std::abs(f.gammaOf("bladder") - 4.0f) < 0.05f);
  QTest::keyClick(&f.slider(), Qt::Key_Escape);
  QVERIFY(f.session.scene() == before);
  sendMouse(f.slider(), QEvent::MouseMove, f.slider().pointOf(Gamma::clamped(1.0f)));
  sendMouse(f.slider(), QEvent::MouseButtonRelease, f.slider().pointOf(Gamma::clamped(1.0f)));
  QVERIFY(f.session.scene() == before);
  QCOMPARE(f.steps(), steps);
}

void GammaPanelTest::aStageIsOneClick() {
  GammaPanelFixture f;
  f.session.select({f.named("bladder"), f.named("aorta")});
  for (const int gamma : {0, 3, 5, 4, 1}) {
    const int steps = f.steps();
    f.click(f.stage(gamma));
    QCOMPARE(f.gammaOf("bladder"), float(gamma));
    QCOMPARE(f.gammaOf("aorta"), float(gamma));
    QCOMPARE(f.steps(), steps + 1);
  }
  // The keyboard chooses a stage, too.
  f.stage(2).setFocus();
  QTest::keyClick(&f.stage(2), Qt::Key_Space);
  QCOMPARE(f.gammaOf("bladder"), 2.0f);
}

void GammaPanelTest::stagesAreLive() {
  GammaPanelFixture f;
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  // Each stage shows more than the one before, and the last has most, the surface's colour.
  QVERIFY(ink(f.stage(0).picture()) > 1.0);
  QVERIFY(ink(f.stage(3).picture()) > 1.02 * ink(f.stage(2).picture()));
  QVERIFY(ink(f.stage(4).picture()) > 1.1 * ink(f.stage(3).picture()));
  QVERIFY(ink(f.stage(5).picture()) > 1.5 * ink(f.stage(3).picture()));
  // A structure that is no longer selected leaves no picture.
  f.session.select({f.named("bladder")});
  QVERIFY(f.stage(5).picture().isNull());
  QVERIFY(f.pictured());
  // A colour changes the stages that show it.
  const QImage before = f.stage(5).picture();
  f.session.apply(
      QStringLiteral("colour"),
      model::withLook(f.session.scene(), f.session.selection(), {.colour = Colour{20, 200, 40}}));
  QVERIFY(QTest::qWaitFor([&] { return f.stage(5).picture() != before; }, minute));
  const QColor middle = f.stage(5).picture().pixelColor(f.stage(5).picture().rect().center());
  QVERIFY(middle.green() > 2 * middle.red());
  // The side it is seen from changes them too, but Γ does not: the stages are what they are.
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  const QImage seen = f.stage(1).picture();
  f.window.viewport().showFrom(model::AnatomicalView::superior);
  QVERIFY(QTest::qWaitFor([&] { return f.stage(1).picture() != seen; }, minute));
  // A group shows all that is in it.
  f.session.select({f.named("Organs")});
  QVERIFY(f.pictured());
}

void GammaPanelTest::picturesComeFirst() {
  // While new pictures are wanted again and again no small one is drawn, and all come afterwards.
  GammaPanelFixture f;
  f.session.select({f.named("aorta")});
  QVERIFY(f.pictured());
  QSignalSpy small(&f.viewport(), &widgets::Viewport::previewed);
  f.session.select({f.named("bladder")});
  model::Camera camera = f.viewport().camera();
  for (int i = 0; i < 8; ++i) {
    camera.eye.x += 1.0f;
    f.viewport().setCamera(camera);
    QVERIFY(f.settled());
    QCOMPARE(small.count(), 0);
  }
  QVERIFY(f.pictured());
}

void GammaPanelTest::severalValuesAreARange() {
  GammaPanelFixture f;
  const auto set = [&](const char* name, float gamma) {
    f.session.select({f.named(name)});
    f.click(f.stage(int(gamma)));
  };
  set("bladder", 1.0f);
  set("left kidney", 3.0f);
  const int steps = f.steps();
  f.session.select({f.named("bladder"), f.named("left kidney")});
  QVERIFY(f.number().isMixed());
  QVERIFY2(f.number().text().contains(QLocale().toString(1.0, 'f', 2)) &&
               f.number().text().contains(QLocale().toString(3.0, 'f', 2)),
           qPrintable(f.number().text()));
  QCOMPARE(f.steps(), steps);
  // Giving both the value that one of them already has is still a change.
  f.number().setFocus();
  f.number().selectAll();
  QTest::keyClicks(&f.number(), QLocale().toString(3.0, 'f', 2));
  QTest::keyClick(&f.number(), Qt::Key_Return);
  QCOMPARE(f.gammaOf("bladder"), 3.0f);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(!f.number().isMixed());
  // Leaving the box as it is changes nothing.
  f.session.undo();
  f.number().setFocus();
  f.slider().setFocus();
  QCOMPARE(f.gammaOf("bladder"), 1.0f);
}

void GammaPanelTest::aDragDrawsOneLayer() {
  GammaPanelFixture f;
  const model::NodeId id = f.named("left kidney");
  f.session.select({id});
  QVERIFY(f.settled());
  QVERIFY(f.pictured());
  const auto& slider = f.slider();
  sendMouse(f.slider(), QEvent::MouseButtonPress,
            slider.pointOf(f.session.scene().resolve(id).gamma));
  for (const float gamma : {1.6f, 1.2f, 2.4f, 2.9f, 3.5f, 4.4f}) {
    sendMouse(f.slider(), QEvent::MouseMove, slider.pointOf(Gamma::clamped(gamma)));
    QVERIFY(f.settled());
    QCOMPARE(f.viewport().lastLayersDrawn(), 1);
  }
  sendMouse(f.slider(), QEvent::MouseButtonRelease, slider.pointOf(Gamma::clamped(4.4f)));
}

SLINE_TEST_WITH_WIDGETS(GammaPanelTest)
#include "gamma_panel_test.moc"
