// SPDX-License-Identifier: Apache-2.0
// Tests focus by nearness in the window: to what is selected, and to a place that is dragged.
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QtTest>
#include <glm/geometric.hpp>

#include "model/camera/camera_moves.h"
#include "model/edit/look.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/focus/near_tool.h"
#include "widgets/viewport/tools/points.h"

using namespace sline;
using namespace sline::test;
using model::GammaScalar;

namespace {

struct NearFixture : GammaPanelFixture {
  NearFixture() {
    QTest::keyClick(&window, Qt::Key_A);
    if (!settled())
      qFatal("no picture");
  }
  QPointF pixel(const glm::vec3& p) {
    const QSizeF size = viewport().size();
    return widgets::point(
        *model::pixelOf(viewport().camera(), p, {float(size.width()), float(size.height())}));
  }
  glm::vec3 middle(const char* name) {
    return session.scene().find(named(name))->mesh->bounds().centre();
  }
  std::optional<model::FocusNearness> nearness() { return session.scene().focus().nearness; }
  model::ResolvedStyle look(const char* name) { return session.scene().resolve(named(name)); }
};

}  // namespace

class NearFocusWindowTest : public QObject {
  Q_OBJECT
 private slots:
  void everythingIsNearTheSelected();
  void aPlaceIsClicked();
  void thePlaceIsDragged();
  void theReachIsDragged();
  void escapeLeavesPlacing();
  void theUsualFocusReplacesIt();
};

void NearFocusWindowTest::everythingIsNearTheSelected() {
  NearFixture f;
  f.session.select({f.named("left kidney")});
  const int steps = f.steps();
  QTest::keyClick(&f.window, Qt::Key_F, Qt::ShiftModifier);
  QTRY_COMPARE(f.steps(), steps + 1);
  QVERIFY(f.nearness() && !f.nearness()->place);
  QVERIFY(f.look("left kidney").gamma.value() > 4.0f);
  const model::GammaMap map = f.look("right kidney").gammaMap;
  QCOMPARE(map.scalar, GammaScalar::distance);
  QVERIFY(map.targets == std::vector{f.named("left kidney")});
  QVERIFY(f.settled());
  f.session.undo();
  QVERIFY(!f.nearness());
  QVERIFY(f.look("right kidney").gammaMap == model::GammaMap());
}

void NearFocusWindowTest::aPlaceIsClicked() {
  NearFixture f;
  f.session.select({});
  auto& button = f.control<QPushButton>("nearPlace");
  f.click(button);
  QVERIFY(f.window.nearness().placing());
  const int steps = f.steps();
  const QPointF at = f.pixel(f.middle("bladder"));
  sendMouse(f.viewport(), QEvent::MouseButtonPress, at);
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, at);
  QTRY_COMPARE(f.steps(), steps + 1);
  QVERIFY(!f.window.nearness().placing() && !button.isChecked());
  QVERIFY(f.nearness() && f.nearness()->place);
  // It is on the front of what is seen there.
  const glm::vec3 place = *f.nearness()->place;
  QVERIFY(std::abs(glm::distance(place, f.middle("bladder")) - 20.0f) < 0.5f);
  QVERIFY(place.y < f.middle("bladder").y);
  QVERIFY(f.look("bladder").gammaMap.place == place);
  QCOMPARE(f.control<QLabel>("focusTitle").text(), QString("Nearness to a place"));
  QVERIFY(f.settled());
  QVERIFY(f.window.nearness().mark()->isVisible());
  QVERIFY((widgets::point(*f.window.nearness().mark()->state().place) - at).manhattanLength() < 3);
}

void NearFocusWindowTest::thePlaceIsDragged() {
  NearFixture f;
  f.window.nearness().setPlacing(true);
  const QPointF at = f.pixel(f.middle("bladder"));
  sendMouse(f.viewport(), QEvent::MouseButtonPress, at);
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, at);
  QTRY_VERIFY(f.nearness());
  QVERIFY(f.settled());
  const int steps = f.steps();
  const glm::vec3 before = *f.nearness()->place;
  const QImage picture = f.picture();
  const QPointF to = f.pixel(f.middle("left kidney"));
  sendMouse(f.viewport(), QEvent::MouseButtonPress, at + QPointF(3, 3));
  sendMouse(f.viewport(), QEvent::MouseMove, to);
  QTRY_VERIFY(std::abs(glm::distance(*f.nearness()->place, f.middle("left kidney")) - 20.0f) <
              1.0f);
  QVERIFY(f.session.previewing());
  // The picture follows while the button is down.
  QTRY_VERIFY_WITH_TIMEOUT(!difference(picture, f.picture()).isEmpty(), minute);
  QCOMPARE(f.steps(), steps);
  // With Shift it goes away from the eye.
  const glm::vec3 onKidney = *f.nearness()->place;
  sendMouse(f.viewport(), QEvent::MouseMove, to, Qt::LeftButton, Qt::ShiftModifier);
  sendMouse(f.viewport(), QEvent::MouseMove, to - QPointF(0, 40), Qt::LeftButton,
            Qt::ShiftModifier);
  QTRY_VERIFY(f.nearness()->place->y > onKidney.y + 5.0f);
  QVERIFY((f.pixel(*f.nearness()->place) - to).manhattanLength() < 3.0);
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, to - QPointF(0, 40), Qt::LeftButton,
            Qt::ShiftModifier);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(f.settled());
  f.session.undo();
  QVERIFY(*f.nearness()->place == before);
}

void NearFocusWindowTest::theReachIsDragged() {
  NearFixture f;
  auto& slider = f.control<QSlider>("nearFalloff");
  QVERIFY(!slider.isVisible());
  f.session.select({f.named("aorta")});
  f.click(f.control<QPushButton>("nearSelection"));
  QTRY_VERIFY(f.nearness());
  QVERIFY(slider.isVisibleTo(&f.window));
  const int steps = f.steps();
  const float before = f.nearness()->falloffMm;
  QVERIFY(before > 10.0f && before < 120.0f);
  slider.setSliderDown(true);
  slider.setSliderPosition(slider.maximum());
  slider.setSliderPosition(slider.minimum());
  QTRY_COMPARE(f.nearness()->falloffMm, 1.0f);
  QVERIFY(f.session.previewing());
  QVERIFY(f.look("bladder").gammaMap.curve.back().scalar == 1.0f);
  slider.setSliderDown(false);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(f.control<QLabel>("nearMillimetres").text().contains("1"));
  f.session.undo();
  QCOMPARE(f.nearness()->falloffMm, before);
}

void NearFocusWindowTest::escapeLeavesPlacing() {
  NearFixture f;
  const int steps = f.steps();
  f.window.nearness().setPlacing(true);
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(!f.window.nearness().placing());
  f.window.nearness().setPlacing(true);
  sendMouse(f.viewport(), QEvent::MouseButtonPress, f.pixel(f.middle("bladder")));
  QTRY_VERIFY(f.nearness());
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(!f.nearness());
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, f.pixel(f.middle("bladder")));
  QCOMPARE(f.steps(), steps);
}

void NearFocusWindowTest::theUsualFocusReplacesIt() {
  NearFixture f;
  f.session.select({f.named("left kidney")});
  QTest::keyClick(&f.window, Qt::Key_F, Qt::ShiftModifier);
  QTRY_VERIFY(f.nearness());
  QTest::keyClick(&f.window, Qt::Key_F);
  QTRY_VERIFY(!f.nearness());
  QVERIFY(f.look("right kidney").gammaMap == model::GammaMap());
  QVERIFY(f.session.scene().focus().targets == std::vector{f.named("left kidney")});
}

SLINE_TEST_WITH_WIDGETS(NearFocusWindowTest)
#include "near_focus_window_test.moc"
