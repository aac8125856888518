// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/topology.h"

#include <QtTest>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

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
