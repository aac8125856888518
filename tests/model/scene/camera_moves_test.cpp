// SPDX-License-Identifier: Apache-2.0
// Tests functions from cameras to cameras: what keeps its place, and what moves where the mouse
// goes.
#include <QTest>
#include <glm/geometric.hpp>

#include "model/camera/camera_flight.h"
#include "model/camera/camera_moves.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

constexpr glm::vec2 size(800.0f, 600.0f);

/// Returns where a point stands in the picture that the renderer draws, in pixels from the upper
/// left.
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

class CameraMovesTest : public QObject {
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
    // The camera comes back the way it went.
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

  void pixelsAreThePictures_data() { projections(); }
  void pixelsAreThePictures() {
    QFETCH(int, projection);
    const model::Camera c = orbited(camera(model::Projection(projection)), {}, 25.0f, -35.0f);
    for (const glm::vec3 p : {glm::vec3(0, 0, 0), glm::vec3(60, -20, 30), glm::vec3(-90, 40, 5)})
      QVERIFY(near(*model::pixelOf(c, p, size), pixelOf(c, p)));
    if (c.projection == model::Projection::perspective)
      QVERIFY(!model::pixelOf(c, c.eye + model::cameraFrame(c).back, size));
  }

  void rollTurnsThePictureClockwise() {
    const model::Camera before = camera();
    const glm::vec3 right(50.0f, 0.0f, 0.0f);  // in the anterior view
    const glm::vec2 at = pixelOf(rolled(before, 90.0f), right) - 0.5f * size;
    QVERIFY(std::abs(at.x) < 0.5f && at.y > 10.0f);
    // A drag makes a quarter of a turn clockwise, from the right of the middle to below it.
    const CameraDrag drag(
        {.kind = CameraDrag::Kind::roll, .pixel = {600.0f, 300.0f}, .camera = before});
    const glm::vec2 dragged = pixelOf(drag.at({400.0f, 500.0f}, size), right) - 0.5f * size;
    QVERIFY(near(dragged, at, 0.5f));
  }

  void zoomDragKeepsThePivot() {
    const glm::vec3 pivot(20.0f, 0.0f, 10.0f);
    const CameraDrag drag({.kind = CameraDrag::Kind::zoom,
                           .pixel = {400.0f, 300.0f},
                           .camera = camera(),
                           .pivot = pivot});
    const model::Camera nearer = drag.at({400.0f, 200.0f}, size);
    QVERIFY(near(pixelOf(nearer, pivot), pixelOf(camera(), pivot)));
    QVERIFY(glm::length(nearer.eye - pivot) < 0.9f * glm::length(camera().eye - pivot));
    QVERIFY(glm::length(drag.at({400.0f, 400.0f}, size).eye - pivot) >
            1.1f * glm::length(camera().eye - pivot));
  }

  /// However long one zooms, and wherever the mouse is, the scene neither becomes a speck nor is
  /// lost between two floats; and one step back is a step.
  void zoomHasEnds_data() {
    QTest::addColumn<int>("projection");
    QTest::addColumn<float>("factor");
    QTest::addColumn<float>("share");  // of the scene's size, that the picture shows in the end
    for (const auto& [name, projection] : {std::pair("perspective", Projection::perspective),
                                           std::pair("orthographic", Projection::orthographic)}) {
      QTest::addRow("%s, in", name) << int(projection) << 1.15f << 1e-4f;
      QTest::addRow("%s, out", name) << int(projection) << 1.0f / 1.15f << 100.0f;
    }
  }
  void zoomHasEnds() {
    QFETCH(int, projection);
    QFETCH(float, factor);
    QFETCH(float, share);
    const model::Box bounds{{-60, -30, -80}, {60, 30, 80}};
    const model::ZoomEnds ends = model::zoomEnds(bounds);
    const float whole = glm::length(bounds.size());
    const auto shown = [](const model::Camera& c, const glm::vec3& at) {
      return millimetresPerPixel(c, at, 1.0f);
    };
    model::Camera c = camera(model::Projection(projection));
    const glm::vec2 mouse(130.0f, 420.0f);
    glm::vec3 at(0.0f);
    for (int notch = 0; notch < 400; ++notch) {
      at = pointAtDepthOf(c, glm::vec3(0.0f), mouse, size);
      c = zoomedWithin(c, at, factor, ends);
      QVERIFY(!model::cameraFault(c));
    }
    QVERIFY2(std::abs(shown(c, at) / (share * whole) - 1.0f) < 0.05f,
             qPrintable(QString::number(shown(c, at) / whole)));
    const model::Camera back = zoomedWithin(c, at, 1.0f / factor, ends);
    QVERIFY(std::abs(shown(back, at) / (factor * shown(c, at)) - 1.0f) < 0.05f);
    // A drag ends where the wheel does.
    const CameraDrag drag(
        {.kind = CameraDrag::Kind::zoom, .pixel = mouse, .camera = c, .pivot = at, .ends = ends});
    const glm::vec2 on = mouse + glm::vec2(0.0f, factor > 1.0f ? -400.0f : 400.0f);
    QVERIFY(std::abs(shown(drag.at(on, size), at) / shown(c, at) - 1.0f) < 0.05f);
  }

  void farFromTheOriginZoomEndsSooner() {
    const model::Box near{{-5, -5, -5}, {5, 5, 5}};
    const model::Box far{{99'995, -5, -5}, {100'005, 5, 5}};
    QVERIFY(model::zoomEnds(far).least > 10.0f * model::zoomEnds(near).least);
    QVERIFY(model::zoomEnds({}).least > 0.0f);
    const model::ZoomEnds point = model::zoomEnds(model::Box{{1, 2, 3}, {1, 2, 3}});
    QVERIFY(point.least == 0.0f && point.greatest > 1e30f);
  }

  void fromBeyondAnEndOneComesBack() {
    const model::ZoomEnds ends{.least = 1.0f, .greatest = 100.0f};
    model::Camera c = camera(model::Projection::orthographic);
    c.heightMm = 0.01f;
    QVERIFY(zoomedWithin(c, {}, 2.0f, ends) == c);
    QCOMPARE(zoomedWithin(c, {}, 0.5f, ends).heightMm, 0.02f);
    c.heightMm = 1e5f;
    QVERIFY(zoomedWithin(c, {}, 0.5f, ends) == c);
    QCOMPARE(zoomedWithin(c, {}, 2.0f, ends).heightMm, 5e4f);
  }

  void turnedToKeepsThePivot() {
    const model::Camera before = orbited(camera(), {}, 33.0f, 12.0f);
    const glm::vec3 pivot(30.0f, -10.0f, 20.0f);
    const model::Camera after = turnedTo(before, pivot, {1.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f});
    QVERIFY(near(pixelOf(before, pivot), pixelOf(after, pivot)));
    const glm::vec3 back = model::cameraFrame(after).back;
    QVERIFY(glm::length(back - glm::normalize(glm::vec3(1, 0, 1))) < 1e-5f);
  }

  void flightsEndWhereTheyShould() {
    const model::Camera from = camera();
    const model::Camera to = turnedTo(zoomed(from, {10, 0, 0}, 2.0f), {}, {1, 0, 0}, {0, 0, 1});
    const model::CameraFlight flight(from, to);
    QVERIFY(flight.at(0.0) == from);
    QVERIFY(flight.at(1.0) == to);
    QVERIFY(flight.at(7.0) == to);
    float turned = 0.0f;
    for (int i = 1; i <= 10; ++i) {
      const model::Camera c = flight.at(0.1 * i);
      QVERIFY(!model::cameraFault(c));
      const float now = glm::dot(model::cameraFrame(c).back, model::cameraFrame(to).back);
      QVERIFY(now > turned);  // always nearer
      turned = now;
      QVERIFY(model::cameraFrame(c).up.z > 0.99f);  // and level
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

SLINE_TEST(CameraMovesTest)
#include "camera_moves_test.moc"
