// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/fairing/half_edges.h"
#include "model/fairing/windowed_sinc.h"
#include "model/meshing/loop_subdivision.h"
#include "model/meshing/smoothing.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  bool operator==(const Soup&) const = default;
};

Soup soup(const Mesh& mesh) {
  return {{mesh.positions().begin(), mesh.positions().end()},
          {mesh.triangles().begin(), mesh.triangles().end()}};
}

Smoothed automatic(Soup& s) {
  const std::vector<SurfaceMeasure> measures{measureSurface(s.positions, s.triangles)};
  return smooth(s.positions, s.triangles, commonGrids(measures).front(), {});
}

/// Returns the mean angle between neighbouring faces, in degrees.
double bend(const Soup& s) {
  const HalfEdges edges(s.positions.size(), s.triangles);
  const auto normal = [&](std::size_t t) {
    const Triangle& v = s.triangles[t];
    return glm::normalize(
        glm::cross(s.positions[v[1]] - s.positions[v[0]], s.positions[v[2]] - s.positions[v[0]]));
  };
  double sum = 0.0;
  for (std::uint32_t h = 0; h < edges.count(); ++h)
    if (edges.hasOpposite(h))
      sum += std::acos(
          std::clamp(double(glm::dot(normal(h / 3), normal(edges.opposite(h) / 3))), -1.0, 1.0));
  return sum / double(edges.count()) * 57.29578;
}

bool ballOf20(const glm::vec3& p) {
  return glm::distance(p, glm::vec3(24.2f, 24.1f, 23.9f)) < 20.0f;
}
/// Tells whether a point is in a slanted rod with steps that a smoothing filter likes to shrink
/// away.
bool slantedRod(const glm::vec3& p) {
  const glm::vec3 axis = glm::normalize(glm::vec3(0.35f, 0.2f, 1.0f));
  const glm::vec3 q = p - glm::vec3(30.0f, 30.0f, 30.0f);
  const float along = glm::dot(q, axis);
  return glm::length(q - along * axis) < 4.0f && std::abs(along) < 25.0f;
}

}  // namespace

class SmoothingTest : public QObject {
  Q_OBJECT
 private slots:
  void filterPassesLowAndStopsHigh();
  void cleanShapesStayBitEqual_data();
  void cleanShapesStayBitEqual();
  void jitterIsNoStaircase();
  void stepsOfABallGo();
  void rodKeepsItsThickness();
  void spacingIsFound();
  void greyValueSurfaceIsClean();
  void siblingsShareTheGrid();
  void offAndSteps();
  void coarseSphereIsRefined();
  void coarsestAreRefinedFirst();
  void boxIsLeftAlone();
  void loopKeepsBorders();
  void nonManifoldSurvives();
};

void SmoothingTest::filterPassesLowAndStopsHigh() {
  const SincFilter filter;
  const std::vector<double> c = sincCoefficients(filter);
  const auto response = [&](double k) {
    double sum = 0.0;
    for (std::size_t n = 0; n < c.size(); ++n)
      sum += c[n] * std::cos(double(n) * std::acos(1.0 - 0.5 * k));
    return sum;
  };
  QVERIFY(std::abs(response(0.0) - 1.0) < 1e-9);
  for (double k = 0.0; k <= double(filter.passBand); k += 0.005)
    QVERIFY2(std::abs(response(k) - 1.0) < 0.01, qPrintable(QString::number(k)));
  for (double k = 6.0 * double(filter.passBand); k <= 2.0; k += 0.01)
    QVERIFY2(std::abs(response(k)) < 0.01, qPrintable(QString::number(k)));
}

void SmoothingTest::cleanShapesStayBitEqual_data() {
  QTest::addColumn<int>("shape");
  QTest::newRow("fine sphere") << 0;
  QTest::newRow("fine torus") << 1;
  QTest::newRow("fine tube with rings at equal heights") << 2;
  QTest::newRow("fine saddle on a grid") << 3;
}

void SmoothingTest::cleanShapesStayBitEqual() {
  QFETCH(int, shape);
  const MeshPtr mesh = shape == 0   ? test::sphere(50, 7)
                       : shape == 1 ? test::torus(40, 15, 400, 160)
                       : shape == 2 ? test::cylinder(15, 60, 160, 120)
                                    : test::paraboloid(0.02f, -0.02f, 30, 200);
  Soup s = soup(*mesh);
  const Smoothed done = automatic(s);
  QCOMPARE(done.smoothingSteps, 0);
  QCOMPARE(done.refinementSteps, 0);
  QCOMPARE(done.displacement, 0.0f);
  QVERIFY(s == soup(*mesh));
}

void SmoothingTest::jitterIsNoStaircase() {
  const MeshPtr mesh = test::jittered(*test::sphere(50, 6), 0.35f, 7,
                                      [](const glm::vec3& p) { return 50.0f * glm::normalize(p); });
  Soup s = soup(*mesh);
  QCOMPARE(automatic(s).smoothingSteps, 0);
}

void SmoothingTest::stepsOfABallGo() {
  const glm::vec3 centre(24.2f, 24.1f, 23.9f);
  Soup s = soup(*test::voxelSurface(48, ballOf20));
  const Soup before = s;
  const double bendBefore = bend(before);
  std::vector<SurfaceMeasure> measures{measureSurface(s.positions, s.triangles)};
  const VoxelGrid grid = commonGrids(measures).front();
  QVERIFY(grid.found());
  const Smoothed done = smooth(s.positions, s.triangles, grid, {});
  QCOMPARE(done.smoothingSteps, 60);
  QVERIFY(done.displacement > 0.1f);
  QVERIFY2(bend(s) < 0.33 * bendBefore,
           qPrintable(QString("%1° to %2°").arg(bendBefore).arg(bend(s))));
  double before2 = 0.0;
  double after2 = 0.0;
  for (std::size_t v = 0; v < before.positions.size(); ++v) {
    // The limit is half a step height, across a surface that is at most √3 voxels thick.
    QVERIFY(glm::distance(s.positions[v], before.positions[v]) <= 0.5f * 1.7321f);
    before2 += std::pow(double(glm::distance(before.positions[v], centre)) - 20.0, 2.0);
    after2 += std::pow(double(glm::distance(s.positions[v], centre)) - 20.0, 2.0);
  }
  QVERIFY2(after2 < 0.25 * before2, qPrintable(QString("%1 → %2").arg(before2).arg(after2)));
}

void SmoothingTest::rodKeepsItsThickness() {
  Soup s = soup(*test::voxelSurface(60, slantedRod));
  const auto thickness = [](const Soup& soup) {
    const glm::vec3 axis = glm::normalize(glm::vec3(0.35f, 0.2f, 1.0f));
    double sum = 0.0;
    int count = 0;
    for (const glm::vec3& p : soup.positions) {
      const glm::vec3 q = p - glm::vec3(30.0f);
      const float along = glm::dot(q, axis);
      if (std::abs(along) > 18.0f)
        continue;
      sum += double(glm::length(q - along * axis));
      ++count;
    }
    return sum / count;
  };
  const double before = thickness(s);
  const std::vector<SurfaceMeasure> measures{measureSurface(s.positions, s.triangles)};
  std::vector<glm::vec3> positions = s.positions;
  std::vector<Triangle> triangles = s.triangles;
  const Smoothed done = smooth(positions, triangles, commonGrids(measures).front(), {});
  QCOMPARE(done.smoothingSteps, 60);
  const double after = thickness({positions, triangles});
  QVERIFY2(std::abs(after / before - 1.0) < 0.05,
           qPrintable(QString("%1 → %2").arg(before).arg(after)));
}

void SmoothingTest::spacingIsFound() {
  Soup s = soup(*test::voxelSurface(48, ballOf20));
  for (glm::vec3& p : s.positions)
    p = p * glm::vec3(0.9375f, 0.9375f, 1.25f) + glm::vec3(-119.53f, 20.1f, 33.3f);
  const VoxelGrid grid = measureSurface(s.positions, s.triangles).grid;
  QVERIFY(std::abs(grid.spacing.x - 0.9375f) < 0.005f);
  QVERIFY(std::abs(grid.spacing.y - 0.9375f) < 0.005f);
  QVERIFY(std::abs(grid.spacing.z - 1.25f) < 0.005f);
}

void SmoothingTest::greyValueSurfaceIsClean() {
  // Marching cubes make such vertices of a smooth field: two coordinates on the grid, the third
  // anywhere.
  std::vector<glm::vec3> grey;
  std::vector<glm::vec3> labels;
  std::uint32_t seed = 1;
  const auto random = [&] {
    return float((seed = seed * 1664525u + 1013904223u) >> 8) / 16777216.0f;
  };
  for (int i = 0; i < 6000; ++i) {
    glm::vec3 p(std::floor(40.0f * random()), std::floor(40.0f * random()),
                std::floor(40.0f * random()));
    const int axis = i % 3;
    p[axis] += 0.5f;
    labels.push_back(p);
    p[axis] += random() - 0.5f;
    grey.push_back(p);
  }
  const VoxelGrid grid{glm::vec3(1.0f), glm::vec3(1000.0f)};
  QVERIFY(isGreyValueSurface(grey, grid));
  QVERIFY(!isGreyValueSurface(labels, grid));
}

void SmoothingTest::siblingsShareTheGrid() {
  const auto strong = [](float x) {
    return SurfaceMeasure{5000, 1.1f, {{x, x, 1.5f}, {200, 200, 100}}, false};
  };
  const SurfaceMeasure small{300, 1.0f, {{1.3f, 0.7f, 0.0f}, {5, 4, 0}}, false};
  const SurfaceMeasure coarse{300, 9.0f, {{8, 8, 8}, {5, 4, 3}}, false};
  const std::vector<SurfaceMeasure> three{strong(0.94f), strong(0.935f), strong(0.94f), small,
                                          coarse};
  const std::vector<VoxelGrid> grids = commonGrids(three);
  QVERIFY(std::abs(grids[3].spacing.x - 0.94f) < 0.01f);
  QCOMPARE(grids[3].spacing.z, 1.5f);
  QVERIFY(!grids[4].found());
  const std::vector<SurfaceMeasure> one{strong(0.94f), small};
  QVERIFY(commonGrids(one)[0].found());
  QVERIFY(!commonGrids(one)[1].found());
}

void SmoothingTest::offAndSteps() {
  const Soup before = soup(*test::voxelSurface(48, ballOf20));
  Soup s = before;
  Smoothed done = smooth(s.positions, s.triangles, {}, {Smoothing::Mode::off, 0});
  QVERIFY(s == before);
  QCOMPARE(done.smoothingSteps, 0);
  done = smooth(s.positions, s.triangles, {}, {Smoothing::Mode::steps, 20});
  QCOMPARE(done.smoothingSteps, 20);
  QCOMPARE(done.refinementSteps, 0);
  QVERIFY(bend(s) < 0.5 * bend(before));
}

void SmoothingTest::coarseSphereIsRefined() {
  Soup s = soup(*test::sphere(10, 2));
  const std::size_t triangles = s.triangles.size();
  const Smoothed done = automatic(s);
  QCOMPARE(done.smoothingSteps, 0);
  QCOMPARE(done.refinementSteps, 2);
  QCOMPARE(s.triangles.size(), 16 * triangles);
  QCOMPARE(HalfEdges(s.positions.size(), s.triangles).openCount(), std::size_t(0));
  // The scheme is nearly interpolating: Loop's own rule would pull the sphere in by 0.3.
  QVERIFY2(done.displacement < 0.05f, qPrintable(QString::number(double(done.displacement))));
  for (const glm::vec3& p : s.positions)
    QVERIFY(std::abs(glm::length(p) - 10.0f) < 0.1f);
}

void SmoothingTest::coarsestAreRefinedFirst() {
  const auto measure = [](std::size_t triangles, float share) {
    SurfaceMeasure m;
    m.triangles = triangles;
    m.meanEdge = 10.0f * share;
    m.featureSize = 10.0f;
    return m;
  };
  // Alone, each gets what it needs; fine ones need nothing.
  QCOMPARE(refinementAllowances(std::vector{measure(1000, 0.07f)}), std::vector{2});
  QCOMPARE(refinementAllowances(std::vector{measure(1000, 0.03f)}), std::vector{1});
  QCOMPARE(refinementAllowances(std::vector{measure(1000, 0.01f)}), std::vector{0});
  // 599,000 may be added: the coarsest would take 1,500,000 for two steps and takes one for
  // 300,000; the next wants as much, which is 1,000 too many; the last has its 3,000.
  QCOMPARE(refinementAllowances(std::vector{measure(100'000, 0.05f), measure(100'000, 0.08f),
                                            measure(1'000, 0.021f)}),
           (std::vector{0, 1, 1}));
}

void SmoothingTest::boxIsLeftAlone() {
  const Soup box{
      {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 9}, {9, 0, 9}, {9, 9, 9}, {0, 9, 9}},
      {{0, 2, 1},
       {0, 3, 2},
       {4, 5, 6},
       {4, 6, 7},
       {0, 1, 5},
       {0, 5, 4},
       {1, 2, 6},
       {1, 6, 5},
       {2, 3, 7},
       {2, 7, 6},
       {3, 0, 4},
       {3, 4, 7}}};
  Soup s = box;
  QCOMPARE(automatic(s).refinementSteps, 0);
  QVERIFY(s == box);
}

void SmoothingTest::loopKeepsBorders() {
  const Soup flat = soup(*test::paraboloid(0.0f, 0.0f, 10, 4));
  const Subdivided fine = loopSubdivided(flat.positions, flat.triangles);
  QCOMPARE(fine.triangles.size(), 4 * flat.triangles.size());
  float high = 0.0f;
  for (const glm::vec3& p : fine.positions) {
    QVERIFY(std::abs(p.z) < 1e-5f);
    high = std::max(high, p.x);
  }
  QCOMPARE(high, 10.0f);
}

void SmoothingTest::nonManifoldSurvives() {
  // There are three sheets along one edge, and a vertex in no face.
  Soup s{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {5, 5, 5}},
         {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const Subdivided fine = loopSubdivided(s.positions, s.triangles);
  QCOMPARE(fine.triangles.size(), std::size_t(12));
  QCOMPARE(fine.positions[5], glm::vec3(5.0f));
  smooth(s.positions, s.triangles, {}, {Smoothing::Mode::steps, 10});
  for (const glm::vec3& p : s.positions)
    QVERIFY(std::isfinite(p.x + p.y + p.z));
}

SLINE_TEST(SmoothingTest)
#include "smoothing_test.moc"
