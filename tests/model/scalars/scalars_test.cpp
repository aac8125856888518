// SPDX-License-Identifier: Apache-2.0
// Tests the fields over surfaces for which they are known in closed form.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "model/geometry/surface.h"
#include "model/scalars/distance.h"
#include "model/scalars/mean_curvature.h"
#include "model/scalars/occlusion.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  return std::make_shared<const Mesh>(
      Mesh::create(std::move(positions), std::move(triangles)).value());
}

MeshPtr turnedInsideOut(const Mesh& mesh) {
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (Triangle& t : triangles)
    std::swap(t[1], t[2]);
  return meshOf({mesh.positions().begin(), mesh.positions().end()}, std::move(triangles));
}

/// Returns the lower half of a ball's surface seen from inside, open at z = 0.
MeshPtr pit(float radius, int levels) {
  const MeshPtr ball = turnedInsideOut(*test::sphere(radius, levels));
  std::vector<Triangle> lower;
  for (const Triangle& t : ball->triangles())
    if (std::all_of(t.begin(), t.end(),
                    [&](std::uint32_t v) { return ball->positions()[v].z < 1e-3f * radius; }))
      lower.push_back(t);
  return meshOf({ball->positions().begin(), ball->positions().end()}, std::move(lower));
}

/// Returns two squares of the half side that face each other at that distance.
MeshPtr plates(float halfSide, float apart, int cells) {
  const MeshPtr low = test::paraboloid(0.0f, 0.0f, halfSide, cells);
  return test::together(*low,
                        *test::moved(*turnedInsideOut(*low), 1.0f, glm::vec3(0.0f, 0.0f, apart)));
}

/// Returns the part of the sky that a square hides whose middle stands above a point of a parallel
/// plane.
double hiddenBySquare(double halfSide, double apart) {
  const double a = halfSide / apart;
  const double root = std::sqrt(1.0 + a * a);
  return 4.0 / (2.0 * M_PI) * 2.0 * a / root * std::atan(a / root);
}

float largestStep(const Mesh& mesh, const std::vector<float>& field) {
  float most = 0.0f;
  for (const Triangle& t : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k)
      most = std::max(most, std::abs(field[t[k]] - field[t[(k + 1) % 3]]));
  return most;
}

}  // namespace

class ScalarsTest : public QObject {
  Q_OBJECT
 private slots:
  void nothingHidesTheSkyOfAConvexBody_data() {
    QTest::addColumn<int>("levels");
    QTest::newRow("coarse") << 2;
    QTest::newRow("rays from each vertex") << 4;
    QTest::newRow("rays from some vertices") << 7;
  }
  void nothingHidesTheSkyOfAConvexBody() {
    QFETCH(int, levels);
    const std::vector<float> field = ambientOcclusion(*prepareSurface(test::sphere(7.0f, levels)));
    QCOMPARE(*std::max_element(field.begin(), field.end()), 0.0f);
  }

  void insideAClosedBodyAllIsHidden() {
    const std::vector<float> field =
        ambientOcclusion(*prepareSurface(turnedInsideOut(*test::sphere(7.0f, 4))));
    QCOMPARE(*std::min_element(field.begin(), field.end()), 1.0f);
  }

  // From a point within a sphere each part of it hides as much sky as it has area: of a half sphere
  // one half, wherever the point lies.
  void halfTheSkyIsHiddenInAHemisphericalPit_data() {
    QTest::addColumn<int>("levels");
    QTest::newRow("rays from each vertex") << 5;
    QTest::newRow("rays from some vertices") << 7;
  }
  void halfTheSkyIsHiddenInAHemisphericalPit() {
    QFETCH(int, levels);
    constexpr float radius = 20.0f;
    const MeshPtr mesh = pit(radius, levels);
    const std::vector<float> field = ambientOcclusion(*prepareSurface(mesh));
    double sum = 0.0;
    int count = 0;
    float farthest = 0.0f;
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (!(mesh->positions()[v].z < -0.1f * radius))
        continue;
      sum += double(field[v]);
      ++count;
      farthest = std::max(farthest, std::abs(field[v] - 0.5f));
    }
    QVERIFY2(std::abs(sum / count - 0.5) < 0.005, qPrintable(QString::number(sum / count)));
    QVERIFY2(farthest < 0.03f, qPrintable(QString::number(farthest)));
    QVERIFY2(largestStep(*mesh, field) < 0.04f,
             qPrintable(QString::number(largestStep(*mesh, field))));
  }

  void platesHideEachOthersSky_data() {
    QTest::addColumn<float>("apart");
    QTest::newRow("near") << 4.0f;
    QTest::newRow("as far as wide") << 20.0f;
    QTest::newRow("far") << 60.0f;
  }
  void platesHideEachOthersSky() {
    QFETCH(float, apart);
    constexpr float halfSide = 10.0f;
    const MeshPtr mesh = plates(halfSide, apart, 60);
    const std::vector<float> field = ambientOcclusion(*prepareSurface(mesh));
    int middles = 0;
    for (std::size_t v = 0; v < field.size(); ++v)
      if (std::hypot(mesh->positions()[v].x, mesh->positions()[v].y) < 1e-3f) {
        const double truth = hiddenBySquare(double(halfSide), double(apart));
        QVERIFY2(std::abs(double(field[v]) - truth) < 0.012,
                 qPrintable(QStringLiteral("%1, not %2").arg(double(field[v])).arg(truth)));
        ++middles;
      }
    QCOMPARE(middles, 2);
  }

  void occlusionIsTheSameEachTime() {
    const SurfacePtr surface = prepareSurface(test::torus(10.0f, 4.0f, 400, 100));
    QVERIFY(ambientOcclusion(*surface) == ambientOcclusion(*surface));
  }

  void surfacesWithoutTrianglesHaveFieldsToo() {
    const SurfacePtr surface = prepareSurface(meshOf({glm::vec3(1.0f)}, {}));
    QCOMPARE(ambientOcclusion(*surface), std::vector<float>{0.0f});
    QCOMPARE(meanCurvature(*surface), std::vector<float>{0.0f});
  }

  void meanCurvatureOfASphereIsOne_data() {
    QTest::addColumn<float>("radius");
    QTest::addColumn<bool>("hollow");
    QTest::newRow("small") << 0.02f << false;
    QTest::newRow("large") << 300.0f << false;
    QTest::newRow("hollow") << 5.0f << true;
  }
  void meanCurvatureOfASphereIsOne() {
    QFETCH(float, radius);
    QFETCH(bool, hollow);
    const MeshPtr ball = test::sphere(radius, 5);
    for (const float h : meanCurvature(*prepareSurface(hollow ? turnedInsideOut(*ball) : ball)))
      QVERIFY2(std::abs(h - (hollow ? -1.0f : 1.0f)) < 0.01f, qPrintable(QString::number(h)));
  }

  void meanCurvatureOfATorus() {
    constexpr float major = 10.0f;
    constexpr float minor = 3.0f;
    const MeshPtr mesh = test::torus(major, minor, 300, 100);
    const std::vector<float> field = meanCurvature(*prepareSurface(mesh));
    for (std::size_t v = 0; v < field.size(); ++v) {
      const float r = std::hypot(mesh->positions()[v].x, mesh->positions()[v].y);
      const float truth = 0.5f * (1.0f / minor + (r - major) / minor / r) * (major + minor);
      QVERIFY2(std::abs(field[v] - truth) < 0.05f,
               qPrintable(QStringLiteral("%1, not %2").arg(field[v]).arg(truth)));
    }
  }

  void distancesOfBalls() {
    const MeshPtr ball = test::sphere(10.0f, 5);
    const MeshPtr other = test::moved(*ball, 1.0f, glm::vec3(50.0f, 0.0f, 0.0f));
    std::vector<glm::vec3> points;
    for (int i = 0; i < 600; ++i)
      points.emplace_back(0.1f * float(i), 3.0f * std::sin(float(i)), 0.05f * float(i % 37));
    const std::vector<float> one = distancesTo(std::array{ball}, points);
    const std::vector<float> both = distancesTo(std::array{other, ball}, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float first = std::abs(glm::length(points[i]) - 10.0f);
      const float second = std::abs(glm::distance(points[i], glm::vec3(50.0f, 0.0f, 0.0f)) - 10.0f);
      // The ball's triangles lie within a hundredth of a millimetre of it.
      QVERIFY(std::abs(one[i] - first) < 0.02f);
      QVERIFY(std::abs(both[i] - std::min(first, second)) < 0.02f);
    }
  }

  void nothingIsInfinitelyFar() {
    const std::array points{glm::vec3(0.0f), glm::vec3(1.0f)};
    const std::vector<float> none(2, std::numeric_limits<float>::infinity());
    QCOMPARE(distancesTo({}, points), none);
    QCOMPARE(distancesTo(std::array{meshOf({}, {})}, points), none);
  }
};

SLINE_TEST(ScalarsTest)
#include "scalars_test.moc"
