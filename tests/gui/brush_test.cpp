// SPDX-License-Identifier: Apache-2.0
// Tests painting on structures by the mouse in the picture, on the real window.
#include <QAction>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QtTest>
#include <algorithm>
#include <array>

#include "model/camera/camera_moves.h"
#include "model/edit/locks.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/brush/brush_tool.h"
#include "widgets/viewport/tools/points.h"

using namespace sline;
using namespace sline::test;
using model::GammaScalar;

namespace {

struct BrushFixture : GammaPanelFixture {
  model::NodeId id;

  BrushFixture() {
    id = named("bladder");
    QTest::keyClick(&window, Qt::Key_A);
    session.select({id});
    QTest::keyClick(&window, Qt::Key_B, Qt::ShiftModifier);
    if (!settled() || !tool().active())
      qFatal("there is no brush");
    tool().setBrush({.radius = 20.0f, .softness = 0.0f, .strength = 1.0f});
  }
  widgets::BrushTool& tool() { return window.brush(); }
  const model::Node& node() { return *session.scene().find(id); }
  /// Returns the pixel of the structure's middle, as seen from the front.
  QPointF middle() {
    const QSizeF size = viewport().size();
    const auto pixel = model::pixelOf(viewport().camera(), node().mesh->bounds().centre(),
                                      {float(size.width()), float(size.height())});
    return widgets::point(*pixel);
  }
  void stroke(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers keys = {}) {
    dragMouse(viewport(), from.toPoint(), to.toPoint(), Qt::LeftButton, keys);
  }
  std::size_t painted() {
    const model::PaintPtr& paint = node().paint;
    return paint ? std::size_t(std::count_if(paint->begin(), paint->end(),
                                             [](std::uint8_t value) { return value > 0; }))
                 : 0;
  }
};

}  // namespace

class BrushTest : public QObject {
  Q_OBJECT
 private slots:
  void aStrokePaintsWhatOneSees();
  void theStrokeIsSeenWhileItIsPainted();
  void escapeTakesAStrokeBack();
  void controlErases();
  void besideItNothingTurns();
  void aDragThatComesToItPaints();
  void clicksChooseOthers();
  void keysAndSlidersSetTheBrush();
  void softBrushesPaintLessAtTheirRims();
  void theBarClears();
  void whatIsLockedStays();
  void theSavedSceneHasIt();
  void whereTheBrushHoversIsLookedAhead();
  void whatIsLookedForAheadIsKnown();
};

void BrushTest::aStrokePaintsWhatOneSees() {
  BrushFixture f;
  const int steps = f.steps();
  const QPointF middle = f.middle();
  f.stroke(middle, middle + QPointF(12, 0));
  QCOMPARE(f.steps(), steps + 1);
  QCOMPARE(f.session.history().undoText(), QString("Paint on bladder"));
  QVERIFY(f.painted() > 20);
  QVERIFY(f.painted() < f.node().mesh->vertexCount() / 3);
  QCOMPARE(f.session.scene().resolve(f.id).gammaMap.scalar, GammaScalar::painted);
  // Seen from the front nothing behind is painted, though the disc covers both sides alike.
  const glm::vec3 centre = f.node().mesh->bounds().centre();
  for (std::size_t v = 0; v < f.node().paint->size(); ++v)
    if ((*f.node().paint)[v] > 0)
      QVERIFY(f.node().mesh->positions()[v].y < centre.y);
  // Nothing else is.
  for (const model::Node& node : f.session.scene().nodes())
    QVERIFY(node.id == f.id || !node.paint);
  QVERIFY(f.session.selection() == widgets::NodeIds{f.id});
  f.session.undo();
  QVERIFY(!f.node().paint);
  QVERIFY(f.session.scene().resolve(f.id).gammaMap == model::GammaMap());
  f.session.redo();
  QVERIFY(f.painted() > 20);
}

void BrushTest::theStrokeIsSeenWhileItIsPainted() {
  BrushFixture f;
  const QImage before = f.picture();
  const QPointF middle = f.middle();
  sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
  QVERIFY(f.session.previewing());
  QVERIFY(f.painted() > 0);
  const std::size_t first = f.painted();
  for (int i = 1; i <= 5; ++i)
    sendMouse(f.viewport(), QEvent::MouseMove, middle + QPointF(4.0 * i, 0.0));
  QTRY_VERIFY(f.painted() > first);
  QTRY_VERIFY_WITH_TIMEOUT(!difference(before, f.picture()).isEmpty(), minute);
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle + QPointF(20.0, 0.0));
  QVERIFY(!f.session.previewing());
  QVERIFY(f.settled());
  // The brush itself is over the picture, and is not what differs.
  f.tool().setActive(false);
  const QRect changed = difference(before, f.picture());
  QVERIFY(!changed.isEmpty() && f.areaOf(f.id).contains(changed.center()));
}

void BrushTest::escapeTakesAStrokeBack() {
  BrushFixture f;
  const int steps = f.steps();
  sendMouse(f.viewport(), QEvent::MouseButtonPress, f.middle());
  QVERIFY(f.painted() > 0);
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QCOMPARE(f.painted(), std::size_t(0));
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, f.middle());
  QCOMPARE(f.steps(), steps);
  QVERIFY(f.tool().active());
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QVERIFY(!f.tool().active());
  QVERIFY(!f.control<QAction>("brush").isChecked());
}

void BrushTest::controlErases() {
  BrushFixture f;
  const QPointF middle = f.middle();
  f.stroke(middle - QPointF(15, 0), middle + QPointF(15, 0));
  const std::size_t all = f.painted();
  f.stroke(middle, middle + QPointF(5, 0), Qt::ControlModifier);
  QCOMPARE(f.session.history().undoText(), QString("Erase on bladder"));
  const std::size_t rest = f.painted();
  QVERIFY(rest < all && rest > 0);
  // The button makes the plain stroke erase, and Ctrl paint.
  f.click(f.control<QToolButton>("brushErase"));
  QVERIFY(f.tool().brush().erases);
  f.tool().setBrush({.radius = 200.0f, .softness = 0.0f, .erases = true});
  f.stroke(middle, middle + QPointF(2, 0));
  QCOMPARE(f.painted(), std::size_t(0));
  QVERIFY(!f.node().paint);
  f.stroke(middle, middle + QPointF(2, 0), Qt::ControlModifier);
  QVERIFY(f.painted() > 0);
}

void BrushTest::besideItNothingTurns() {
  BrushFixture f;
  const model::Camera camera = f.viewport().camera();
  const int steps = f.steps();
  for (const Qt::KeyboardModifiers keys : {Qt::NoModifier, Qt::ControlModifier})
    f.stroke({12, 60}, {60, 90}, keys);
  QCOMPARE(f.steps(), steps);
  QVERIFY(f.viewport().camera() == camera);
  QVERIFY(f.session.selection() == widgets::NodeIds{f.id});
  // Nor where there is nothing to paint on.
  f.session.select({});
  f.stroke(f.middle(), f.middle() + QPointF(40, 0));
  QVERIFY(f.viewport().camera() == camera);
  // Put away, it leaves the mouse to the camera.
  f.tool().setActive(false);
  f.stroke({12, 60}, {60, 90});
  QVERIFY(!(f.viewport().camera() == camera));
}

void BrushTest::aDragThatComesToItPaints() {
  BrushFixture f;
  const model::Camera camera = f.viewport().camera();
  const int steps = f.steps();
  sendMouse(f.viewport(), QEvent::MouseButtonPress, {12, 60});
  QCOMPARE(f.painted(), std::size_t(0));
  // What one sees there is looked for beside the window: a busy machine takes a few moves longer.
  constexpr int most = 100;
  for (int i = 0; i < 4 || (f.painted() == 0 && i < most); ++i) {
    sendMouse(f.viewport(), QEvent::MouseMove, f.middle() + QPointF(3.0 * (i % 4), 0.0));
    QVERIFY(f.settled());
  }
  QVERIFY(f.painted() > 0);
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, f.middle() + QPointF(12.0, 0.0));
  QCOMPARE(f.steps(), steps + 1);
  QCOMPARE(f.session.history().undoText(), QString("Paint on bladder"));
  QVERIFY(f.viewport().camera() == camera);
}

void BrushTest::clicksChooseOthers() {
  BrushFixture f;
  const model::NodeId other = f.named("left kidney");
  const QSizeF size = f.viewport().size();
  const auto at =
      model::pixelOf(f.viewport().camera(), f.session.scene().find(other)->mesh->bounds().centre(),
                     {float(size.width()), float(size.height())});
  QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, widgets::point(*at).toPoint());
  QTRY_VERIFY(f.session.selection() == widgets::NodeIds{other});
  QVERIFY(f.tool().active());
  f.stroke(widgets::point(*at), widgets::point(*at) + QPointF(3, 0));
  QVERIFY(f.session.scene().find(other)->paint);
  QVERIFY(!f.node().paint);
}

void BrushTest::keysAndSlidersSetTheBrush() {
  BrushFixture f;
  const float radius = f.tool().brush().radius;
  QTest::keyClick(&f.window, Qt::Key_BracketRight);
  QVERIFY(f.tool().brush().radius > radius);
  QTest::keyClick(&f.window, Qt::Key_BracketLeft);
  QVERIFY(std::abs(f.tool().brush().radius - radius) < 0.1f);
  auto& size = f.control<QSlider>("brushSize");
  size.setValue(size.maximum());
  QCOMPARE(f.tool().brush().radius, widgets::brushRadii.high);
  f.control<QSlider>("brushSoftness").setValue(30);
  QVERIFY(std::abs(f.tool().brush().softness - 0.3f) < 1e-4f);
  f.control<QSlider>("brushStrength").setValue(40);
  QVERIFY(std::abs(f.tool().brush().strength - 0.4f) < 1e-4f);
  // The circle has the brush's size, where the mouse is.
  f.tool().setBrush({.radius = 33.0f});
  sendMouse(f.viewport(), QEvent::MouseMove, f.middle(), Qt::NoButton);
  f.tool().show({.camera = f.viewport().camera(),
                 .size = {float(f.viewport().width()), float(f.viewport().height())},
                 .mouse = widgets::vec(f.middle())});
  QCOMPARE(f.tool().mark()->state().brush.radius, 33.0f);
  QVERIFY(f.tool().mark()->state().onTarget);
  QVERIFY(f.tool().mark()->isVisible());
  QVERIFY(f.control<QLabel>("brushMillimetres").text().endsWith("mm"));
  // Without the brush its keys do nothing.
  QTest::keyClick(&f.window, Qt::Key_B, Qt::ShiftModifier);
  QVERIFY(!f.tool().active());
  QVERIFY(!f.control<QWidget>("brushBar").isVisible());
  QTest::keyClick(&f.window, Qt::Key_BracketRight);
  QCOMPARE(f.tool().brush().radius, 33.0f);
}

void BrushTest::softBrushesPaintLessAtTheirRims() {
  BrushFixture f;
  f.tool().setBrush({.radius = 30.0f, .softness = 1.0f, .strength = 0.5f});
  sendMouse(f.viewport(), QEvent::MouseButtonPress, f.middle());
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, f.middle());
  QVERIFY(f.node().paint);
  int most = 0;
  bool less = false;
  for (const std::uint8_t value : *f.node().paint) {
    most = std::max(most, int(value));
    less = less || (value > 0 && value < 60);
  }
  QVERIFY2(most > 110 && most <= 128, std::to_string(most).c_str());
  QVERIFY(less);
  // A second stroke goes half of the rest of the way.
  sendMouse(f.viewport(), QEvent::MouseButtonPress, f.middle());
  sendMouse(f.viewport(), QEvent::MouseButtonRelease, f.middle());
  const int now = *std::max_element(f.node().paint->begin(), f.node().paint->end());
  QVERIFY2(now > 160 && now <= 192, std::to_string(now).c_str());
}

void BrushTest::theBarClears() {
  BrushFixture f;
  auto& clear = f.control<QToolButton>("brushClear");
  QVERIFY(!clear.isEnabled());
  f.stroke(f.middle(), f.middle() + QPointF(5, 0));
  QVERIFY(clear.isEnabled());
  const int steps = f.steps();
  f.click(clear);
  QCOMPARE(f.steps(), steps + 1);
  QVERIFY(!f.node().paint);
  f.click(f.control<QToolButton>("brushDone"));
  QVERIFY(!f.tool().active());
}

void BrushTest::whatIsLockedStays() {
  BrushFixture f;
  f.session.apply("lock", model::withLocked(f.session.scene(), std::array{f.id}, true));
  const int steps = f.steps();
  f.stroke(f.middle(), f.middle() + QPointF(5, 0));
  QCOMPARE(f.steps(), steps);
  QVERIFY(!f.node().paint);
}

void BrushTest::theSavedSceneHasIt() {
  BrushFixture f;
  f.stroke(f.middle(), f.middle() + QPointF(9, 0));
  const model::Paint paint = *f.node().paint;
  const std::string bytes = *model::sceneFileBytes({.scene = f.session.scene()});
  const auto again = model::documentFromBytes(bytes);
  QVERIFY(again.ok());
  QVERIFY(again->scene.find(f.id)->paint && *again->scene.find(f.id)->paint == paint);
  // All of it takes less than a byte a vertex.
  const std::string plain = *model::sceneFileBytes({.scene = [&] {
    model::Scene bare = f.session.scene();
    std::vector<model::Node> nodes = bare.nodes();
    for (model::Node& node : nodes)
      node.paint = nullptr;
    bare.setNodes(std::move(nodes));
    return bare;
  }()});
  QVERIFY(bytes.size() - plain.size() < paint.size());
}

void BrushTest::whereTheBrushHoversIsLookedAhead() {
  BrushFixture f;
  const QPointF middle = f.middle();
  QVERIFY(!f.tool().lookedAhead());
  f.stroke(middle, middle + QPointF(12, 0));
  const model::Paint paint = *f.node().paint;
  f.session.undo();
  model::Camera camera = f.viewport().camera();
  camera.eye.x += 1.0f;
  f.viewport().setCamera(camera);
  QVERIFY(f.settled());
  const auto hovers = [&f](const QPointF& at) {
    sendMouse(f.viewport(), QEvent::MouseMove, at, Qt::NoButton);
    return f.tool().lookedAhead();
  };
  QTRY_VERIFY(hovers(middle));
  f.stroke(middle, middle + QPointF(12, 0));
  QVERIFY(!f.tool().lookedAhead());
  QVERIFY(f.painted() > 20);
  camera.eye.x -= 1.0f;
  f.session.undo();
  f.viewport().setCamera(camera);
  QVERIFY(f.settled());
  QTRY_VERIFY(hovers(middle));
  f.stroke(middle, middle + QPointF(12, 0));
  QVERIFY(*f.node().paint == paint);
}

void BrushTest::whatIsLookedForAheadIsKnown() {
  const model::MeshPtr ring = torus(30.0f, 10.0f, 240, 96);
  const widgets::BrushSight::From from{
      .ground = widgets::brushGround(ring),
      .camera = model::anatomicalCamera(model::AnatomicalView::anterior, ring->bounds(), 1.0f),
      .size = {400.0f, 400.0f}};
  const auto seen = [&ring](const widgets::BrushSight& sight) {
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < ring->vertexCount(); ++v)
      count += sight.sees(v) ? 1 : 0;
    return count;
  };
  widgets::SightAhead ahead;
  QCOMPARE(seen(*ahead.take(from)), std::size_t(0));
  widgets::BrushSight::From other = from;
  other.size.x = 500.0f;
  ahead.want(other);
  QTRY_VERIFY(ahead.arrived());
  const widgets::BrushSightPtr known = ahead.take(other);
  const std::size_t all = seen(*known);
  // From the side a ring hides the inner half of what is turned to the eye.
  QVERIFY(all > ring->vertexCount() / 5);
  QVERIFY(all < 2 * ring->vertexCount() / 5);
  QCOMPARE(ahead.take(other), known);
  QCOMPARE(seen(*ahead.take(from)), std::size_t(0));
}

SLINE_TEST_WITH_WIDGETS(BrushTest)
#include "brush_test.moc"
