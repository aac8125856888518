// SPDX-License-Identifier: Apache-2.0
#include "model/cuts/plane_section.h"

#include <QTest>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "model/cuts/odd_even_fill.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

Q_DECLARE_METATYPE(sline::model::MeshPtr)

namespace sline::model {
namespace {

constexpr double pi = std::numbers::pi;

Plane plane(const glm::vec3& normal, float offset) {
  return {glm::normalize(normal), offset};
}

/// Returns the mesh turned inside out.
MeshPtr turned(const Mesh& mesh) {
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (Triangle& t : triangles)
    std::swap(t[1], t[2]);
  return std::make_shared<const Mesh>(
      Mesh::create({mesh.positions().begin(), mesh.positions().end()}, std::move(triangles))
          .value());
}

MeshPtr without(const Mesh& mesh, const std::set<std::size_t>& gone) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i)
    if (!gone.contains(i))
      triangles.push_back(mesh.triangles()[i]);
  return std::make_shared<const Mesh>(
      Mesh::create({mesh.positions().begin(), mesh.positions().end()}, std::move(triangles))
          .value());
}

double lengthOf(const PlaneSection& section) {
  double length = 0.0;
  for (const CutSegment& s : section.segments)
    length += double(glm::distance(s.a, s.b));
  return length;
}

using Key = std::array<float, 3>;
Key key(const glm::vec3& p) {
  return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

/// Returns the number of end points that an odd number of segments share.
std::size_t looseEnds(const PlaneSection& section) {
  std::map<Key, int> uses;
  for (const CutSegment& s : section.segments) {
    ++uses[key(s.a)];
    ++uses[key(s.b)];
  }
  return std::size_t(
      std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second % 2 != 0; }));
}

/// Returns the length of the edges that belong to only one triangle of the cap: with no T-junction
/// inside, it is that of the outline.
double rimOf(const std::vector<glm::vec3>& cap) {
  std::map<std::pair<Key, Key>, int> uses;
  const auto edge = [](const glm::vec3& a, const glm::vec3& b) {
    return std::minmax({key(a), key(b)});
  };
  for (std::size_t i = 0; i < cap.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      ++uses[edge(cap[i + k], cap[i + (k + 1) % 3])];
  double length = 0.0;
  for (const auto& [ends, count] : uses)
    if (count % 2 != 0)
      length += std::hypot(ends.first[0] - ends.second[0], ends.first[1] - ends.second[1],
                           ends.first[2] - ends.second[2]);
  return length;
}

}  // namespace

class PlaneSectionTest : public QObject {
  Q_OBJECT

 private slots:
  void sphereIsDisc_data();
  void sphereIsDisc();
  void knownAreas_data();
  void knownAreas();
  void capsHaveNoCracks_data() { knownAreas_data(); }
  void capsHaveNoCracks();
  void missesLeaveNothing();
  void sheetsAreNotCapped();
  void specksAreBridged();
  void mirroredMeshMirroredSection();
  void fills_data();
  void fills();
  void keptPointsAreKept();
};

void PlaneSectionTest::sphereIsDisc_data() {
  QTest::addColumn<float>("x");
  QTest::addColumn<float>("y");
  QTest::addColumn<float>("z");
  QTest::addColumn<float>("offset");
  QTest::newRow("middle, along vertices") << 0.0f << 0.0f << 1.0f << 0.0f;
  QTest::newRow("sagittal") << 1.0f << 0.0f << 0.0f << 12.5f;
  QTest::newRow("other side") << -1.0f << 0.0f << 0.0f << -12.5f;
  QTest::newRow("slanted") << 1.0f << -2.0f << 3.0f << -20.0f;
  QTest::newRow("near the rim") << 0.3f << 0.4f << 0.2f << 38.0f;
}

void PlaneSectionTest::sphereIsDisc() {
  QFETCH(float, x);
  QFETCH(float, y);
  QFETCH(float, z);
  QFETCH(float, offset);
  const Plane cut = plane({x, y, z}, offset);
  const PlaneSection section = planeSection(*prepareSurface(test::sphere(40.0f, 5)), cut);
  const double radius = std::sqrt(1600.0 - double(offset) * double(offset));
  QVERIFY(!section.segments.empty());
  QCOMPARE(looseEnds(section), std::size_t(0));
  for (const CutSegment& s : section.segments)
    for (const glm::vec3& p : {s.a, s.b}) {
      QVERIFY(std::abs(cut.distance(p)) < 1e-5);
      const double r = glm::length(glm::dvec3(p) - double(offset) * glm::dvec3(cut.normal));
      // A chord of the icosphere lies up to 0.03 mm below it; near the rim that is seen at a slant.
      QVERIFY2(std::abs(r - radius) < 0.03 * 40.0 / radius, qPrintable(QString::number(r)));
    }
  QVERIFY(std::abs(section.capArea / (pi * radius * radius) - 1.0) < 0.006);
  QVERIFY(std::abs(lengthOf(section) / (2.0 * pi * radius) - 1.0) < 0.003);
}

void PlaneSectionTest::knownAreas_data() {
  QTest::addColumn<MeshPtr>("mesh");
  QTest::addColumn<float>("x");
  QTest::addColumn<float>("y");
  QTest::addColumn<float>("z");
  QTest::addColumn<double>("area");
  const MeshPtr ring = test::torus(40.0f, 12.0f, 200, 100);
  const MeshPtr ball = test::sphere(40.0f, 5);
  const MeshPtr small = test::sphere(25.0f, 5);
  const double annulus = pi * (1600.0 - 625.0);
  QTest::newRow("torus across its ring: two discs")
      << ring << 1.0f << 0.0f << 0.0f << 2.0 * pi * 144.0;
  QTest::newRow("torus along its ring: an annulus")
      << ring << 0.0f << 0.0f << 1.0f << pi * (52.0 * 52.0 - 28.0 * 28.0);
  QTest::newRow("cavity facing inwards")
      << test::together(*ball, *turned(*small)) << 0.2f << 0.1f << 1.0f << annulus;
  QTest::newRow("cavity facing outwards")
      << test::together(*ball, *small) << 1.0f << 1.0f << 0.0f << annulus;
  QTest::newRow("island in a cavity")
      << test::together(*test::together(*ball, *turned(*small)), *test::sphere(10.0f, 5)) << 0.0f
      << 1.0f << 0.3f << annulus + pi * 100.0;
}

void PlaneSectionTest::knownAreas() {
  QFETCH(MeshPtr, mesh);
  QFETCH(float, x);
  QFETCH(float, y);
  QFETCH(float, z);
  QFETCH(double, area);
  const PlaneSection section = planeSection(*prepareSurface(mesh), plane({x, y, z}, 0.0f));
  QCOMPARE(looseEnds(section), std::size_t(0));
  QVERIFY2(std::abs(section.capArea / area - 1.0) < 0.006,
           qPrintable(QString::number(section.capArea / area)));
}

void PlaneSectionTest::capsHaveNoCracks() {
  QFETCH(MeshPtr, mesh);
  QFETCH(float, x);
  QFETCH(float, y);
  QFETCH(float, z);
  const Plane cut = plane({x, y, z}, 0.0f);
  const PlaneSection section = planeSection(*prepareSurface(mesh), cut);
  double area = 0.0;
  for (std::size_t i = 0; i < section.cap.size(); i += 3) {
    const glm::dvec3 a(section.cap[i]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(section.cap[i + 1]) - a, glm::dvec3(section.cap[i + 2]) - a);
    // Each triangle faces the side that is taken away; slivers may round to the other.
    QVERIFY(glm::dot(normal, glm::dvec3(cut.normal)) > -1e-4);
    area += 0.5 * glm::length(normal);
  }
  QVERIFY(std::abs(area / section.capArea - 1.0) < 1e-4);
  QVERIFY(std::abs(rimOf(section.cap) / lengthOf(section) - 1.0) < 1e-4);
}

void PlaneSectionTest::missesLeaveNothing() {
  const SurfacePtr ball = prepareSurface(test::sphere(10.0f, 3));
  for (const float offset : {10.5f, -10.5f}) {
    const PlaneSection section = planeSection(*ball, plane({1, 0, 0}, offset));
    QVERIFY(section.segments.empty());
    QVERIFY(section.cap.empty());
    QCOMPARE(section.capArea, 0.0);
  }
}

void PlaneSectionTest::sheetsAreNotCapped() {
  const SurfacePtr tube = prepareSurface(test::cylinder(10.0f, 30.0f, 64, 12));
  QVERIFY(!tube->solid);
  const PlaneSection across = planeSection(*tube, plane({0, 0, 1}, 3.0f));
  QVERIFY(std::abs(lengthOf(across) / (2.0 * pi * 10.0) - 1.0) < 0.002);
  QVERIFY(across.cap.empty());
  const PlaneSection along = planeSection(*tube, plane({1, 0, 0}, 3.0f));
  QCOMPARE(looseEnds(along), std::size_t(4));
  QVERIFY(along.cap.empty());
}

void PlaneSectionTest::specksAreBridged() {
  const MeshPtr ball = test::sphere(40.0f, 5);
  const PlaneSection whole = planeSection(*prepareSurface(ball), plane({0, 1, 0.2f}, 4.0f));
  std::set<std::size_t> gone;
  for (std::size_t i = 0; i < whole.segments.size(); i += whole.segments.size() / 2)
    gone.insert(whole.segments[i].triangle);
  const SurfacePtr specked = prepareSurface(without(*ball, gone));
  QVERIFY(!specked->closed);
  QVERIFY(specked->solid);
  const PlaneSection section = planeSection(*specked, plane({0, 1, 0.2f}, 4.0f));
  QCOMPARE(looseEnds(section), std::size_t(0));
  QVERIFY(std::abs(section.capArea / whole.capArea - 1.0) < 1e-3);
}

void PlaneSectionTest::mirroredMeshMirroredSection() {
  const MeshPtr shape = test::moved(*test::torus(30.0f, 9.0f, 90, 40), 1.0f, {5, 2, -3});
  const PlaneSection left = planeSection(*prepareSurface(shape), plane({1, 2, 3}, 4.0f));
  const PlaneSection right =
      planeSection(*prepareSurface(test::mirrored(*shape)), plane({-1, 2, 3}, 4.0f));
  QVERIFY(std::abs(left.capArea / right.capArea - 1.0) < 1e-6);
  std::set<Key> points;
  for (const CutSegment& s : left.segments)
    points.insert(key({-s.a.x, s.a.y, s.a.z}));
  std::set<Key> mirrored;
  for (const CutSegment& s : right.segments)
    mirrored.insert(key(s.a));
  for (const CutSegment& s : right.segments)
    mirrored.insert(key(s.b));
  QVERIFY(!points.empty());
  QVERIFY(std::includes(mirrored.begin(), mirrored.end(), points.begin(), points.end()));
}

void PlaneSectionTest::fills_data() {
  using Loop = std::vector<glm::dvec2>;
  QTest::addColumn<std::vector<Loop>>("loops");
  QTest::addColumn<double>("area");
  const auto square = [](double x, double y, double half) {
    return Loop{
        {x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
  };
  QTest::newRow("nothing") << std::vector<Loop>{} << 0.0;
  QTest::newRow("square") << std::vector<Loop>{square(0, 0, 1)} << 4.0;
  QTest::newRow("triangle on its tip") << std::vector<Loop>{{{0, 0}, {3, 2}, {-1, 2}}} << 4.0;
  QTest::newRow("hole with an island")
      << std::vector{square(0, 0, 3), square(0.2, 0.1, 2), square(0.3, 0, 1)} << 36.0 - 16.0 + 4.0;
  QTest::newRow("side by side, one corner touching")
      << std::vector{square(0, 0, 1), square(2, 2, 1)} << 8.0;
  QTest::newRow("the same loop twice") << std::vector{square(0, 0, 1), square(0, 0, 1)} << 0.0;
  QTest::newRow("comb") << std::vector<Loop>{{{0, 0},
                                              {7, 0},
                                              {7, 5},
                                              {6, 5},
                                              {6, 1},
                                              {4, 1},
                                              {4, 5},
                                              {3, 5},
                                              {3, 1},
                                              {1, 1},
                                              {1, 5},
                                              {0, 5}}}
                        << 7.0 + 3.0 * 4.0;
}

void PlaneSectionTest::fills() {
  using Loop = std::vector<glm::dvec2>;
  QFETCH(std::vector<Loop>, loops);
  QFETCH(double, area);
  std::vector<std::array<glm::dvec2, 2>> edges;
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  std::mt19937 random(7);
  for (int round = 0; round < 3; ++round) {
    std::shuffle(edges.begin(), edges.end(), random);
    for (auto& edge : edges)
      if (random() % 2 == 0)
        std::swap(edge[0], edge[1]);
    const FlatFill fill = oddEvenFill(edges);
    QVERIFY2(std::abs(fill.area - area) < 1e-9, qPrintable(QString::number(fill.area)));
  }
}

void PlaneSectionTest::keptPointsAreKept() {
  const MeshPtr ball = test::sphere(10.0f, 3);
  QCOMPARE(keptPoints(*ball, {}).size(), ball->vertexCount());
  const std::vector<Plane> planes{plane({1, 0, 0}, 2.0f), plane({0, 0, -1}, 1.0f)};
  Box box;
  for (const glm::vec3& p : keptPoints(*ball, planes))
    box.add(p);
  QVERIFY(std::abs(box.high.x - 2.0f) < 1e-5f);
  QVERIFY(std::abs(box.low.z + 1.0f) < 1e-5f);
  QVERIFY(std::abs(box.low.x + 10.0f) < 0.1f);
}

}  // namespace sline::model

SLINE_TEST_WITH_EVENTS(sline::model::PlaneSectionTest)
#include "plane_section_test.moc"
