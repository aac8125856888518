// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/topology.h"

#include <QtTest>
#include <cmath>
#include <ctime>

#include "model/geometry/face_neighbours.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

/// What looked at each pair of those that meet would not come to an end here.
constexpr std::uint32_t many = 1'000'000;

/// Returns leaves that all share one edge, or a double cone: a fan around either of two vertices.
model::MeshPtr crowded(bool cone) {
  std::vector<glm::vec3> positions{{0, 0, -1}, {0, 0, 1}};
  std::vector<model::Triangle> triangles;
  for (std::uint32_t i = 0; i < many; ++i) {
    const double angle = 6.283185307 * double(i) / double(many);
    positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    const std::uint32_t next = 2 + (i + 1) % many;
    if (cone)
      triangles.insert(triangles.end(), {{2 + i, next, 1}, {next, 2 + i, 0}});
    else
      triangles.push_back({0, 1, 2 + i});
  }
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions), std::move(triangles))).value());
}

}  // namespace

class TopologyTest : public QObject {
  Q_OBJECT
 private slots:
  void everyCornerIsListedOnce() {
    const auto mesh = test::torus(10, 3, 24, 12);
    const model::VertexFaces faces(*mesh);
    std::size_t corners = 0;
    for (std::size_t v = 0; v < mesh->vertexCount(); ++v) {
      QCOMPARE(faces[v].size(), std::size_t(6));
      for (const std::uint32_t f : faces[v]) {
        const auto& t = mesh->triangles()[f];
        QVERIFY(t[0] == v || t[1] == v || t[2] == v);
      }
      corners += faces[v].size();
    }
    QCOMPARE(corners, 3 * mesh->triangleCount());
  }

  void edges_data() {
    QTest::addColumn<model::MeshPtr>("mesh");
    QTest::addColumn<int>("open");
    QTest::addColumn<int>("nonManifold");
    const auto fin = std::make_shared<const model::Mesh>(
        std::move(model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}))
            .value());
    QTest::newRow("sphere") << test::sphere(1, 2) << 0 << 0;
    QTest::newRow("torus") << test::torus(4, 1, 10, 8) << 0 << 0;
    QTest::newRow("tube") << test::cylinder(1, 2, 16, 3) << 32 << 0;
    QTest::newRow("three faces at an edge") << model::MeshPtr(fin) << 6 << 1;
  }
  void edges() {
    QFETCH(model::MeshPtr, mesh);
    QFETCH(int, open);
    QFETCH(int, nonManifold);
    const model::EdgeCount count = model::countEdges(*mesh, model::VertexFaces(*mesh));
    QCOMPARE(int(count.open), open);
    QCOMPARE(int(count.nonManifold), nonManifold);
    QCOMPARE(count.closed(), open == 0 && nonManifold == 0);
  }

  void neighboursWhereManyMeet() {
    const auto cone = crowded(true);
    const model::FaceNeighbours around(*cone);
    for (const std::uint32_t i : {0u, 1u, many - 1}) {
      // Triangle 2i is (ring i, next, tip 1), and the one below has the same edge of the ring.
      QCOMPARE(around.across(2 * i, 2), 2 * i + 1);
      QCOMPARE(around.across(2 * i, 0), 2 * ((i + 1) % many));
      QCOMPARE(around.across(2 * i, 1), 2 * ((i + many - 1) % many));
    }
    const auto leaves = crowded(false);
    const model::FaceNeighbours none(*leaves);
    for (const std::uint32_t i : {0u, many / 2, many - 1})
      for (int corner = 0; corner < 3; ++corner)
        QCOMPARE(none.across(i, corner), model::FaceNeighbours::none);
    const model::EdgeCount count = model::countEdges(*leaves, model::VertexFaces(*leaves));
    QCOMPARE(count.open, std::size_t(2 * many));
    QCOMPARE(count.nonManifold, std::size_t(1));
    // Only the common edge, 2 mm long and used an even number of times, is no rim.
    const double rims = model::rimLength(*leaves, model::VertexFaces(*leaves));
    QVERIFY(std::abs(rims / (2 * many * std::sqrt(2.0)) - 1.0) < 1e-4);
  }

  void components() {
    const auto one = test::sphere(1, 1);
    std::vector<glm::vec3> positions(one->positions().begin(), one->positions().end());
    std::vector<model::Triangle> triangles(one->triangles().begin(), one->triangles().end());
    const auto count = std::uint32_t(positions.size());
    for (std::uint32_t i = 0; i < count; ++i)
      positions.push_back(positions[i] + glm::vec3(5, 0, 0));
    for (const auto& t : one->triangles())
      triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    const auto both = model::Mesh::create(positions, triangles);
    const model::Components parts = model::connectedComponents(both.value());
    QCOMPARE(parts.count, std::size_t(2));
    QCOMPARE(parts.ofTriangle.front(), 0u);
    QCOMPARE(parts.ofTriangle.back(), 1u);
    QCOMPARE(model::connectedComponents(*one).count, std::size_t(1));
  }
};

SLINE_TEST(TopologyTest)
#include "topology_test.moc"
