// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/cut_faces.h"

#include <QTest>
#include <numbers>

#include "model/geometry/spatial_order.h"
#include "render/lines/hatching/clipping.h"
#include "render/lines/techniques/lines.h"
#include "render/lines/techniques/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {
namespace {

using model::Plane;
using Planes = std::vector<Plane>;

Plane plane(const glm::vec3& normal, float offset) {
  return {glm::normalize(normal), offset};
}

double lengthOf(const std::vector<Segment>& segments) {
  double length = 0.0;
  for (const Segment& s : segments)
    length += double(glm::distance(s.a, s.b));
  return length;
}

model::Camera lookingFrom(const glm::vec3& eye) {
  model::Camera camera;
  camera.eye = eye;
  if (eye.x == 0.0f && eye.y == 0.0f)
    camera.up = {0.0f, 1.0f, 0.0f};
  return camera;
}

}  // namespace

class CutFacesTest : public QObject {
  Q_OBJECT

 private slots:
  void clips_data();
  void clips();
  void sharedEndsStayShared();
  void linesStayOnTheKeptSide_data();
  void linesStayOnTheKeptSide();
  void hatchingStopsAtTheCut();
  void wedgeHasACorner();
  void equalPlanesCutOnce();
  void outlineIsSeenFromTheCutSideOnly();
  void whatIsTakenAwayHidesNothing();
};

void CutFacesTest::clips_data() {
  QTest::addColumn<Planes>("planes");
  QTest::addColumn<double>("from");  // end of a segment from x = 0 to x = 10
  QTest::addColumn<double>("to");
  QTest::newRow("none") << Planes{} << 0.0 << 10.0;
  QTest::newRow("all kept") << Planes{plane({1, 0, 0}, 11)} << 0.0 << 10.0;
  QTest::newRow("all gone") << Planes{plane({1, 0, 0}, -1)} << 0.0 << 0.0;
  QTest::newRow("second half gone") << Planes{plane({1, 0, 0}, 5)} << 0.0 << 5.0;
  QTest::newRow("first half gone") << Planes{plane({-1, 0, 0}, -5)} << 5.0 << 10.0;
  QTest::newRow("middle left") << Planes{plane({-1, 0, 0}, -2), plane({1, 1, 0}, 5.0f)} << 2.0
                               << 5.0 * std::numbers::sqrt2;
  QTest::newRow("nothing left in the middle")
      << Planes{plane({1, 0, 0}, 4), plane({-1, 0, 0}, -6)} << 0.0 << 0.0;
  QTest::newRow("in the plane") << Planes{plane({0, 0, 1}, 0)} << 0.0 << 10.0;
  QTest::newRow("ends on it") << Planes{plane({1, 0, 0}, 10)} << 0.0 << 10.0;
  QTest::newRow("touches it from outside") << Planes{plane({1, 0, 0}, 0)} << 0.0 << 0.0;
}

void CutFacesTest::clips() {
  QFETCH(Planes, planes);
  QFETCH(double, from);
  QFETCH(double, to);
  Segment segment;
  segment.b = {10, 0, 0};
  segment.normalA = {0, 0, 1};
  segment.normalB = {0, 1, 0};
  segment.opacityB = 0.0f;
  const auto rest = clipped(segment, planes);
  QCOMPARE(rest.has_value(), to > from);
  if (!rest)
    return;
  QVERIFY(std::abs(double(rest->a.x) - from) < 1e-5);
  QVERIFY(std::abs(double(rest->b.x) - to) < 1e-5);
  QVERIFY(std::abs(double(rest->opacityA) - (1.0 - from / 10.0)) < 1e-5);
  QVERIFY(std::abs(double(rest->opacityB) - (1.0 - to / 10.0)) < 1e-5);
  QVERIFY(std::abs(glm::length(rest->normalA) - 1.0f) < 1e-5f);
}

void CutFacesTest::sharedEndsStayShared() {
  const Plane cut = plane({3, 1, 2}, 0.7f);
  Segment first;
  first.a = {0.1f, 0.2f, -0.4f};
  first.b = {0.31f, 0.17f, 0.29f};
  Segment second;
  second.a = first.b;
  second.b = {-0.2f, 0.5f, 0.1f};
  const auto a = clipped(first, std::span(&cut, 1));
  const auto b = clipped(second, std::span(&cut, 1));
  QVERIFY(a && b && a->b == first.b && b->a == first.b);
}

void CutFacesTest::linesStayOnTheKeptSide_data() {
  QTest::addColumn<Planes>("planes");
  QTest::newRow("sagittal") << Planes{plane({1, 0, 0}, 10)};
  QTest::newRow("slanted") << Planes{plane({1, 2, 3}, 4)};
  QTest::newRow("two") << Planes{plane({0, 1, 0}, 5), plane({0.2f, 0, 1}, 1)};
  QTest::newRow("three") << Planes{plane({0, 1, 0}, 5), plane({0, 0, 1}, 1), plane({-1, 1, 0}, 7)};
}

void CutFacesTest::linesStayOnTheKeptSide() {
  QFETCH(Planes, planes);
  const model::SurfacePtr ring = model::prepareSurface(test::torus(40.0f, 14.0f, 180, 80));
  LineSet lines = extractLines(*ring, lookingFrom({100, -300, 200}), {});
  const std::size_t before = lines[LineKind::contour].size();
  clip(lines[LineKind::contour], planes);
  clip(lines[LineKind::suggestive], planes);
  QVERIFY(!lines[LineKind::contour].empty() && lines[LineKind::contour].size() < before);
  for (const CutFace& face : cutFaces(*ring, planes)) {
    QVERIFY(!face.outline.empty());
    for (const Segment& s : face.outline)
      QVERIFY(std::abs(face.plane.distance(s.a)) < 1e-3);
    lines[LineKind::section].insert(lines[LineKind::section].end(), face.outline.begin(),
                                    face.outline.end());
  }
  for (const auto* kind :
       {&lines[LineKind::contour], &lines[LineKind::suggestive], &lines[LineKind::section]})
    for (const Segment& s : *kind)
      for (const Plane& cut : planes) {
        QVERIFY(cut.distance(s.a) < 1e-3);
        QVERIFY(cut.distance(s.b) < 1e-3);
      }
}

void CutFacesTest::hatchingStopsAtTheCut() {
  // There is a stroke along x from 0 to 10 in steps of 2 that widens, and a dot beyond the plane.
  Hatching hatching;
  for (int i = 0; i < 6; ++i)
    hatching.points.push_back({{2.0f * float(i), 0, 0}, {0, 0, 1}, 0.1f * float(i)});
  hatching.points.push_back({{20, 0, 0}, {0, 0, 1}, 1.0f});
  hatching.points.push_back({{4, 3, 0}, {0, 0, 1}, 1.0f});
  const HatchSeed name{.axis = 2, .level = 1, .i = 7, .j = 8};
  hatching.strokes = {{name, {}, 0, 6}, {{}, {}, 6, 1}, {{}, {}, 7, 1}};
  const auto span = [](const Hatching& h, std::size_t stroke) {
    const HatchStroke& s = h.strokes[stroke];
    return std::pair{h.points[s.first].position.x, h.points[s.first + s.count - 1].position.x};
  };
  Hatching front = hatching;
  clip(front, Planes{plane({1, 0, 0}, 7)});
  QCOMPARE(front.strokes.size(), std::size_t(2));
  QCOMPARE(front.strokes[0].count, 5u);
  QVERIFY(front.strokes[0].seed == name);
  QCOMPARE(span(front, 0), (std::pair{0.0f, 7.0f}));
  QVERIFY(std::abs(front.points[4].halfWidth - 0.35f) < 1e-6f);
  QCOMPARE(span(front, 1), (std::pair{4.0f, 4.0f}));
  // A stroke that leaves and comes back becomes two.
  Hatching bent = hatching;
  bent.points[2].position.z = 5.0f;
  clip(bent, Planes{plane({0, 0, 1}, 1)});
  QCOMPARE(bent.strokes.size(), std::size_t(4));
  QVERIFY(std::abs(span(bent, 0).second - 2.4f) < 1e-5f);
  QVERIFY(std::abs(span(bent, 1).first - 5.6f) < 1e-5f);
  QCOMPARE(span(bent, 1).second, 10.0f);
  Hatching gone = hatching;
  clip(gone, Planes{plane({1, 0, 0}, -1)});
  QVERIFY(gone.strokes.empty() && gone.points.empty());
}

void CutFacesTest::wedgeHasACorner() {
  // A quarter of a ball is kept: two half discs that meet along its diameter.
  const model::SurfacePtr ball = model::prepareSurface(test::sphere(30.0f, 5));
  const Planes planes{plane({1, 0, 0}, 0), plane({0, 1, 0}, 0)};
  const std::vector<CutFace> faces = cutFaces(*ball, planes);
  QCOMPARE(faces.size(), std::size_t(2));
  const double half = std::numbers::pi * 30.0;
  QVERIFY(std::abs(lengthOf(faces[0].outline) - half - 60.0) < 0.5);
  QVERIFY(std::abs(lengthOf(faces[1].outline) - half) < 0.5);
  double corner = 0.0;
  for (const Segment& s : faces[0].outline)
    if (std::abs(s.a.y) < 1e-3f && std::abs(s.b.y) < 1e-3f)
      corner += double(glm::distance(s.a, s.b));
  QVERIFY2(std::abs(corner - 60.0) < 0.2, qPrintable(QString::number(corner)));
}

void CutFacesTest::equalPlanesCutOnce() {
  const model::SurfacePtr ball =
      model::prepareSurface(test::moved(*test::sphere(30.0f, 4), 1.0f, {-300.0f, 800.0f, 120.0f}));
  const Plane cut = plane({1, 2, 3}, float((-300.0 + 1600.0 + 360.0) / std::sqrt(14.0)));
  const Planes twice{cut, cut};
  const std::vector<CutFace> faces = cutFaces(*ball, twice);
  const double whole = lengthOf(cutFaces(*ball, std::span(&cut, 1))[0].outline);
  QVERIFY(whole > 180.0);
  QVERIFY(std::abs(lengthOf(faces[0].outline) - whole) < 1e-6);
  QVERIFY(std::abs(lengthOf(faces[1].outline) - whole) < 1e-6);
}

void CutFacesTest::outlineIsSeenFromTheCutSideOnly() {
  // More than half of the ball is kept, so from behind its rim is hidden.
  const model::MeshPtr mesh = test::sphere(30.0f, 5);
  const model::SurfacePtr ball = model::prepareSurface(mesh);
  const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
  const Plane cut = plane({0, -1, 0}, 12);
  const std::vector<CutFace> faces = cutFaces(*ball, std::span(&cut, 1));
  const auto seen = [&](const glm::vec3& eye) {
    const auto visible = visibleSegments(*ball, bvh, lookingFrom(eye), faces[0].outline, faces);
    return double(std::count(visible.begin(), visible.end(), true)) / double(visible.size());
  };
  QCOMPARE(seen({0, -400, 0}), 1.0);
  QCOMPARE(seen({0, 400, 0}), 0.0);
}

void CutFacesTest::whatIsTakenAwayHidesNothing() {
  // Along its plane the ring hides its hole's contours, until its front half is gone.
  const model::MeshPtr mesh = test::torus(40.0f, 12.0f, 160, 64);
  const model::SurfacePtr ring = model::prepareSurface(mesh);
  const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
  const model::Camera camera = lookingFrom({0, -400, 30});
  const Plane cut = plane({0, -1, 0}, 0);
  std::vector<Segment> contours = extractLines(*ring, camera, {})[LineKind::contour];
  clip(contours, std::span(&cut, 1));
  const std::vector<CutFace> faces = cutFaces(*ring, std::span(&cut, 1));
  const auto visible = visibleSegments(*ring, bvh, camera, contours, faces);
  const auto before = visibleSegments(*ring, bvh, camera, contours);
  const auto count = [](const std::vector<bool>& v) {
    return std::count(v.begin(), v.end(), true);
  };
  QVERIFY(count(visible) > count(before) + 20);
  // No line that the cut face itself covers is seen.
  const Plane other = plane({0, 1, 0}, 0);
  std::vector<Segment> behind = extractLines(*ring, camera, {})[LineKind::contour];
  clip(behind, std::span(&other, 1));
  const auto faces2 = cutFaces(*ring, std::span(&other, 1));
  QCOMPARE(count(visibleSegments(*ring, bvh, camera, behind, faces2)),
           count(visibleSegments(*ring, bvh, camera, behind)));
}

}  // namespace sline::render

SLINE_TEST_WITH_EVENTS(sline::render::CutFacesTest)
#include "cut_faces_test.moc"
