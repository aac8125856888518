// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/clusters.h"

#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "model/geometry/surface.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

class ClustersTest : public QObject {
  Q_OBJECT
 private slots:
  void everyTriangleIsInOneCluster() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 120, 60));
    const model::Clusters& clusters = surface->clusters;
    std::vector<int> seen(surface->mesh->triangleCount());
    for (const model::Cluster& cluster : clusters.items)
      for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
        const std::uint32_t slot = cluster.firstTriangle + i;
        const std::uint32_t triangle = clusters.triangles[slot];
        ++seen[triangle];
        for (std::size_t c = 0; c < 3; ++c) {
          const std::uint32_t vertex =
              clusters.vertices[cluster.firstVertex + clusters.localTriangles[slot][c]];
          QCOMPARE(vertex, surface->mesh->triangles()[triangle][c]);
          QVERIFY(glm::distance(surface->mesh->positions()[vertex], cluster.bounds.centre) <=
                  cluster.bounds.radius);
        }
      }
    QVERIFY(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  }

  // Triangles that share no vertex: the vertex limit, not the triangle limit, ends a cluster.
  void soup() {
    std::vector<glm::vec3> positions;
    std::vector<model::Triangle> triangles;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const float x = float(i);
      positions.insert(positions.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto mesh = std::make_shared<const model::Mesh>(
        std::move(model::Mesh::create(positions, triangles)).value());
    const auto surface = model::prepareSurface(mesh);
    std::size_t count = 0;
    for (const model::Cluster& cluster : surface->clusters.items) {
      QVERIFY(cluster.vertexCount <= model::Clusters::maximumVertices);
      count += cluster.triangleCount;
    }
    QCOMPARE(count, std::size_t(1000));
  }

  // The promise of a cluster's bounds must hold for each of its vertices, from eyes near and far.
  void facingNeverLies_data() {
    QTest::addColumn<model::MeshPtr>("mesh");
    QTest::newRow("sphere") << test::sphere(5, 5);
    QTest::newRow("torus") << test::torus(10, 3, 120, 60);
    QTest::newRow("saddle") << test::paraboloid(0.3f, -0.2f, 5, 60);
  }
  void facingNeverLies() {
    QFETCH(model::MeshPtr, mesh);
    const auto surface = model::prepareSurface(mesh);
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    int decided = 0;
    for (int round = 0; round < 60; ++round) {
      const bool parallel = round % 2 == 0;
      const glm::vec3 direction =
          glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
      const model::EyePoint eye{.value = (parallel ? 1.0f : 6.0f + float(round)) * direction,
                                .atInfinity = parallel};
      for (const model::Cluster& cluster : surface->clusters.items) {
        const model::Facing side = model::facing(cluster, eye);
        if (side == model::Facing::mixed)
          continue;
        ++decided;
        for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
          const std::uint32_t v = surface->clusters.vertices[cluster.firstVertex + i];
          const glm::vec3 d = parallel ? eye.value : eye.value - mesh->positions()[v];
          const float facing = glm::dot(d, surface->normals[v]);
          QVERIFY(side == model::Facing::front ? facing > 0.0f : facing < 0.0f);
        }
      }
    }
    QVERIFY2(decided > 500, "the bounds decide hardly anything");
  }
};

SLINE_TEST(ClustersTest)
#include "clusters_test.moc"
