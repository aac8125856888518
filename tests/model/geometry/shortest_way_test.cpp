// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/geometry/shortest_way.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  Result<Mesh> mesh = Mesh::create(std::move(positions), std::move(triangles));
  return std::make_shared<const Mesh>(std::move(*mesh));
}

/// Returns a thin beam along that direction through that place: two triangles with long sides.
MeshPtr beam(const glm::vec3& along, const glm::vec3& middle) {
  const glm::vec3 half = 50.0f * along;
  const glm::vec3 away(0.0f, 0.0f, middle.z > 0.0f ? 4.0f : -4.0f);
  return meshOf({middle - half, middle + half, middle + half + away, middle - half + away},
                {{0, 1, 2}, {0, 2, 3}});
}

}  // namespace

class ShortestWayTest : public QObject {
  Q_OBJECT
 private slots:
  void betweenBalls() {
    const MeshPtr a = test::sphere(10.0f, 5);
    const MeshPtr b = test::moved(*test::sphere(5.0f, 5), 1.0f, {30.0f, 20.0f, 10.0f});
    const auto way = shortestWay(a, b);
    QVERIFY(way);
    const double expected = std::sqrt(1400.0) - 15.0;
    QVERIFY(std::abs(double(glm::distance(way->from.place, way->to.place)) - expected) < 0.03);
    // Both ends are on their own surface, on the line between the middles.
    QVERIFY(std::abs(glm::length(way->from.place) - 10.0f) < 0.03f);
    QVERIFY(glm::length(glm::cross(glm::normalize(way->from.place),
                                   glm::normalize(glm::vec3(30.0f, 20.0f, 10.0f)))) < 0.05f);
    const auto back = shortestWay(b, a);
    QVERIFY(std::abs(glm::distance(back->from.place, back->to.place) -
                     glm::distance(way->from.place, way->to.place)) < 1e-3f);
  }

  /// Where two edges cross, no corner is near the other surface.
  void betweenEdges() {
    const MeshPtr a = beam({1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    const MeshPtr b = beam({0.6f, 0.8f, 0.0f}, {7.0f, 0.0f, 3.0f});
    const auto way = shortestWay(a, b);
    QVERIFY(way);
    QVERIFY2(std::abs(glm::distance(way->from.place, way->to.place) - 3.0f) < 1e-2f,
             qPrintable(QString::number(glm::distance(way->from.place, way->to.place))));
    QVERIFY(glm::distance(way->from.place, glm::vec3(7.0f, 0.0f, 0.0f)) < 0.5f);
  }

  void surfacesThatMeet() {
    const MeshPtr a = test::sphere(10.0f, 4);
    const MeshPtr b = test::moved(*test::sphere(10.0f, 4), 1.0f, {12.0f, 0.0f, 0.0f});
    const auto way = shortestWay(a, b);
    QVERIFY(way && glm::distance(way->from.place, way->to.place) < 0.05f);
  }

  void nothingToMeasure() {
    const MeshPtr none = meshOf({{0, 0, 0}}, {});
    QVERIFY(!shortestWay(none, test::sphere(1.0f, 2)));
    QVERIFY(!shortestWay(test::sphere(1.0f, 2), none));
  }
};

SLINE_TEST(ShortestWayTest)
#include "shortest_way_test.moc"
