// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/swept.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "model/geometry/topology.h"
#include "model/sculpting/coil.h"
#include "model/sculpting/tube_mesh.h"
#include "tests/model/demo/demo_measures.h"
#include "tests/support/suite.h"

using namespace sline;
using model::Swept;
using model::SweptPoint;

namespace {
constexpr float pi = std::numbers::pi_v<float>;

glm::vec3 gradient(const Swept& swept, const glm::vec3& p) {
  constexpr float h = 0.02f;
  glm::vec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 step(0.0f);
    step[axis] = h;
    g[axis] = (swept.distance(p + step) - swept.distance(p - step)) / (2.0f * h);
  }
  return g;
}

/// Returns a hairpin of radius 6 mm with legs that overlap: their middles are 10 mm apart.
Swept hairpin() {
  std::vector<SweptPoint> points;
  for (float z = 0.0f; z < 60.0f; z += 10.0f)
    points.push_back({{-5, 0, z}, 6.0f});
  points.push_back({{0, 0, 68}, 6.0f});
  for (float z = 60.0f; z > -1.0f; z -= 10.0f)
    points.push_back({{5, 0, z}, 6.0f});
  return Swept(points, {0, 1, 0});
}
}  // namespace

class SweptTest : public QObject {
  Q_OBJECT
 private slots:
  // Around the end of a body that widens the wall goes on without a crease, and its field is a
  // distance: the gradient is a unit vector that turns slowly.
  void capsJoinSmoothly() {
    const Swept swept(
        std::array<SweptPoint, 3>{{{{0, 0, 0}, 8.0f}, {{20, 0, 0}, 14.0f}, {{40, 0, 0}, 16.0f}}},
        {0, 1, 0});
    glm::vec3 before(0.0f);
    for (float along = -7.0f; along < 14.0f; along += 0.25f) {
      // This is the place on the wall over this place of the axis.
      float r = 4.0f;
      while (swept.distance({along, r, 0}) < 0.0f)
        r += 0.01f;
      const glm::vec3 g = gradient(swept, {along, r, 0});
      QVERIFY2(std::abs(glm::length(g) - 1.0f) < 0.05f, std::to_string(along).c_str());
      if (along > -6.5f)
        QVERIFY2(glm::dot(glm::normalize(g), before) > 0.985f, std::to_string(along).c_str());
      before = glm::normalize(g);
    }
  }

  void otherStretches() {
    const Swept swept = hairpin();
    const auto others = [&](const glm::vec3& p) {
      return swept.distanceToOthers(p, swept.place(p), 9.0f);
    };
    QVERIFY(std::abs(others({-7, 0, 20}) - 6.0f) < 0.1f);
    QVERIFY(std::abs(others({-1, 0, 20}) - 0.0f) < 0.1f);
    QCOMPARE(others({-5, 0, 64}), 9.0f);
  }

  // A straight stretch is a cylinder; its triangles face outwards.
  void ringsMakeAClosedCylinder() {
    const Swept swept(std::array<SweptPoint, 2>{{{{0, 0, 0}, 5.0f}, {{0, 0, 60}, 5.0f}}},
                      {0, 1, 0});
    const auto solid = [&](const glm::vec3& p) { return swept.distance(p); };
    const auto mesh =
        model::tubeMesh(swept, {.from = 10, .to = 50, .edge = 0.8f, .rim = 0.5f}, solid);
    QVERIFY(model::countEdges(*mesh, model::VertexFaces(*mesh)).closed());
    const double cylinder = double(pi) * 25.0 * 40.0;
    QVERIFY(std::abs(test::volumeOf(*mesh) / cylinder - 1.0) < 0.02);
    QVERIFY(std::abs(mesh->bounds().size().z - 40.0f) < 0.1f);
  }

  // Loops that would overlap are meshed apart, each up to where the other begins.
  void touchingLoopsStayApart() {
    const Swept swept = hairpin();
    const auto solid = [&](const glm::vec3& p) {
      const model::SweptCoordinates at = swept.place(p);
      return std::max(at.distance,
                      0.5f * (at.distance - swept.distanceToOthers(p, at, 6.0f)) + 0.4f);
    };
    const auto mesh = model::tubeMesh(
        swept, {.from = 5, .to = swept.length() - 5, .edge = 1.2f, .rim = 0.5f}, solid);
    QVERIFY(model::countEdges(*mesh, model::VertexFaces(*mesh)).closed());
    QCOMPARE(model::connectedComponents(*mesh).count, std::size_t(1));
    for (const glm::vec3& p : mesh->positions())
      if (p.z > 15.0f && p.z < 35.0f)
        QVERIFY2(std::abs(p.x) > 0.05f,
                 (std::to_string(p.x) + " at " + std::to_string(p.y) + ", " + std::to_string(p.z))
                     .c_str());
  }

  // Left to settle, a tube gets longer, stays out of where it may not be and out of itself.
  void coilSettles() {
    const std::array<glm::vec3, 4> path{{{-60, 0, 0}, {-20, 5, 0}, {20, -5, 4}, {60, 0, 0}}};
    const model::Field box = [](const glm::vec3& p) {
      return std::min({70.0f - std::abs(p.x), 35.0f - std::abs(p.y), 35.0f - std::abs(p.z)});
    };
    const auto line = model::settledCoil(path, {.radius = 8.0f,
                                                .spacing = 4.0f,
                                                .keepOut = box,
                                                .stages = 12,
                                                .settling = 4,
                                                .growth = 1.12f});
    QVERIFY(line.front() == path.front() && line.back() == path.back());
    float length = 0.0f;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      length += glm::distance(line[i], line[i + 1]);
    QVERIFY2(length > 200.0f, std::to_string(length).c_str());
    for (std::size_t i = 3; i + 3 < line.size(); ++i)
      QVERIFY(box(line[i]) > 6.0f);
    for (std::size_t i = 0; i < line.size(); ++i)
      for (std::size_t k = i + 8; k < line.size(); ++k)
        QVERIFY(glm::distance(line[i], line[k]) > 0.85f * 16.0f);
  }
};

SLINE_TEST(SweptTest)
#include "swept_test.moc"
