// SPDX-License-Identifier: Apache-2.0
// Cameras in, cameras out: what keeps its place, what moves where the mouse goes.
#include <QTest>
#include <glm/geometric.hpp>

#include "widgets/viewport/navigation.h"

using namespace sline;
using namespace sline::widgets;

namespace {

constexpr glm::vec2 size(800.0f, 600.0f);

/// Where a point stands in the picture, in pixels from the upper left.
glm::vec2 pixelOf(const model::Camera& camera, const glm::vec3& p) {
  const model::Box box{p - 50.0f, p + 50.0f};
  const glm::vec4 clip = model::projectionMatrix(camera, box, size.x / size.y) *
                         model::viewMatrix(camera) * glm::vec4(p, 1.0f);
  const glm::vec2 ndc = glm::vec2(clip) / clip.w;
  return 0.5f * size * glm::vec2(1.0f + ndc.x, 1.0f - ndc.y);
}

model::Camera camera(model::Projection projection = model::Projection::perspective) {
  model::Camera c = model::anatomicalCamera(model::AnatomicalView::anterior, {}, 1.0f);
  c.projection = projection;
  return c;
}

bool near(const glm::vec2& a, const glm::vec2& b, float by = 0.05f) {
  return glm::length(a - b) < by;
}

}  // namespace

class NavigationTest : public QObject {
  Q_OBJECT

  static void projections() {
    QTest::addColumn<int>("projection");
    QTest::newRow("perspective") << int(model::Projection::perspective);
    QTest::newRow("orthographic") << int(model::Projection::orthographic);
  }

 private slots:
  void orbitKeepsThePivot_data() { projections(); }
  void orbitKeepsThePivot() {
    QFETCH(int, projection);
    const model::Camera before = camera(model::Projection(projection));
    const glm::vec3 pivot(30.0f, 10.0f, -40.0f);
    const model::Camera after = orbited(before, pivot, 37.0f, 21.0f);
    QVERIFY(near(pixelOf(before, pivot), pixelOf(after, pivot)));
    QVERIFY(std::abs(glm::length(before.eye - pivot) - glm::length(after.eye - pivot)) < 1e-2f);
  }

  void nearSideFollowsTheMouse() {
    const model::Camera before = camera();
    const glm::vec3 nearSide(0.0f, -50.0f, 0.0f);
    const glm::vec2 turned = pixelOf(orbited(before, {}, 10.0f, 0.0f), nearSide);
    QVERIFY(turned.x > pixelOf(before, nearSide).x + 1.0f);
    const glm::vec2 tilted = pixelOf(orbited(before, {}, 0.0f, 10.0f), nearSide);
    QVERIFY(tilted.y > pixelOf(before, nearSide).y + 1.0f);
  }

  void horizonStaysLevel() {
    model::Camera c = camera();
    for (int i = 0; i < 500; ++i)
      c = orbited(c, {5.0f, 6.0f, 7.0f}, float(i % 17) - 6.0f, float(i % 13) - 7.0f);
    QVERIFY(std::abs(model::cameraFrame(c).right.z) < 1e-3f);
    QVERIFY(model::cameraFrame(c).up.z > -1e-3f);
    QVERIFY(!model::cameraFault(c));
  }

  void tiltStopsAtThePoles_data() {
    QTest::addColumn<float>("tilt");
    QTest::addColumn<float>("height");
    QTest::newRow("above") << 200.0f << 1.0f;
    QTest::newRow("below") << -200.0f << -1.0f;
  }
  void tiltStopsAtThePoles() {
    QFETCH(float, tilt);
    QFETCH(float, height);
    const model::Camera pole = orbited(camera(), {}, 30.0f, tilt);
    QVERIFY(!model::cameraFault(pole));
    QVERIFY(std::abs(model::cameraFrame(pole).back.z - height) < 1e-4f);
    // And comes back the way it went.
    const model::Camera back = orbited(pole, {}, -30.0f, -90.0f * height);
    QVERIFY(glm::length(back.eye - camera().eye) < 0.5f);
  }

  void leavesThePolesOfTheAnatomicalViews() {
    for (const auto view : {model::AnatomicalView::superior, model::AnatomicalView::inferior}) {
      const model::Camera c = model::anatomicalCamera(view, {}, 1.0f);
      const float down = view == model::AnatomicalView::superior ? -90.0f : 90.0f;
      const model::CameraFrame frame = model::cameraFrame(orbited(c, {}, 0.0f, down));
      QVERIFY(glm::length(frame.up - glm::vec3(0.0f, 0.0f, 1.0f)) < 1e-4f);
    }
  }

  void panFollowsTheMouse_data() { projections(); }
  void panFollowsTheMouse() {
    QFETCH(int, projection);
    const model::Camera before = orbited(camera(model::Projection(projection)), {}, 30.0f, 20.0f);
    const glm::vec3 at(20.0f, -30.0f, 10.0f);
    const glm::vec2 way(35.0f, -60.0f);
    const model::Camera after = panned(before, at, way, size.y);
    QVERIFY(near(pixelOf(after, at), pixelOf(before, at) + way));
    QVERIFY(glm::length(model::cameraFrame(after).back - model::cameraFrame(before).back) < 1e-5f);
  }

  void zoomKeepsThePlaceUnderTheMouse_data() { projections(); }
  void zoomKeepsThePlaceUnderTheMouse() {
    QFETCH(int, projection);
    const model::Camera before = orbited(camera(model::Projection(projection)), {}, -20.0f, 35.0f);
    const glm::vec2 mouse(130.0f, 420.0f);
    const glm::vec3 pivot(10.0f, 20.0f, 30.0f);
    const glm::vec3 at = pointAtDepthOf(before, pivot, mouse, size);
    QVERIFY(near(pixelOf(before, at), mouse));
    const model::Camera after = zoomed(before, at, 2.0f);
    QVERIFY(near(pixelOf(after, at), mouse));
    // A point at the same depth moves away from it twice as far.
    QVERIFY(near(pixelOf(after, pivot) - mouse, 2.0f * (pixelOf(before, pivot) - mouse), 0.2f));
  }

  void sightsGoThroughTheirPixels_data() { projections(); }
  void sightsGoThroughTheirPixels() {
    QFETCH(int, projection);
    const model::Camera c = orbited(camera(model::Projection(projection)), {}, 70.0f, -15.0f);
    for (const glm::vec2 pixel : {glm::vec2(0, 0), glm::vec2(799, 10), glm::vec2(400, 300)}) {
      const model::Ray ray = sightThrough(c, pixel, size);
      QVERIFY(std::abs(glm::length(ray.direction) - 1.0f) < 1e-5f);
      for (const float t : {700.0f, 1300.0f})
        QVERIFY(near(pixelOf(c, ray.origin + t * ray.direction), pixel, 0.1f));
    }
  }

  void dragsDependOnTheirEndsAlone() {
    const CameraDrag drag({.pixel = {100.0f, 100.0f}, .camera = camera()});
    const model::Camera there = drag.at({300.0f, 250.0f}, size);
    QVERIFY(!(there == camera()));
    QVERIFY(drag.at({300.0f, 250.0f}, size) == there);
    QVERIFY(glm::length(drag.at({100.0f, 100.0f}, size).eye - camera().eye) < 1e-3f);
  }
};

QTEST_APPLESS_MAIN(NavigationTest)
#include "navigation_test.moc"
