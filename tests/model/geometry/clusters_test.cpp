// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/clusters.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
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

  // Triangles that share no vertex make the clusters with the most vertices.
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
      QCOMPARE(cluster.vertexCount, 3 * cluster.triangleCount);
      QVERIFY(cluster.vertexCount <= model::Clusters::maximumVertices);
      count += cluster.triangleCount;
    }
    QCOMPARE(count, std::size_t(1000));
  }

  // Two sheets back to back lie in the same place, but no cluster has triangles of both.
  void clustersFaceOneWay() {
    const auto front = test::paraboloid(0.01f, 0.01f, 20, 64);
    std::vector<model::Triangle> turned(front->triangles().begin(), front->triangles().end());
    for (auto& t : turned)
      std::swap(t[1], t[2]);
    const auto back = std::make_shared<const model::Mesh>(
        std::move(
            model::Mesh::create({front->positions().begin(), front->positions().end()}, turned))
            .value());
    const auto surface = model::prepareSurface(test::together(*front, *back));
    for (const model::Cluster& cluster : surface->clusters.items)
      QVERIFY(cluster.cone.cosine > 0.5f);
  }

  // Triangles that are no candidates are convex or concave at all corners, and what clusters keep
  // of the others is as near to the mesh as it says.
  void samplesAreNear() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 120, 60));
    const model::Clusters& clusters = surface->clusters;
    std::size_t candidates = 0;
    for (const model::Cluster& cluster : clusters.items) {
      candidates += cluster.candidateTriangles;
      for (std::uint32_t i = cluster.candidateTriangles; i < cluster.triangleCount; ++i) {
        int convex = 0;
        int concave = 0;
        for (const std::uint32_t v :
             surface->mesh->triangles()[clusters.triangles[cluster.firstTriangle + i]]) {
          const glm::vec2 k = surface->curvature.k[v];
          convex += k.x > 0.0f && k.y > 0.0f;
          concave += k.x < 0.0f && k.y < 0.0f;
        }
        QVERIFY(convex == 3 || concave == 3);
      }
      for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
        checkPlace(*surface, cluster, i);
      for (std::uint32_t i = 0; i < cluster.candidateVertices; ++i)
        checkBending(*surface, cluster, i);
    }
    QVERIFY(candidates > surface->mesh->triangleCount() / 4);
    QVERIFY(candidates < surface->mesh->triangleCount());
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

  // A group says of all its clusters what each says of itself.
  void groupsBoundTheirClusters() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 240, 120));
    const model::Clusters& clusters = surface->clusters;
    constexpr std::size_t most = model::Clusters::itemsOfGroup;
    QCOMPARE(clusters.groups.size(), (clusters.items.size() + most - 1) / most);
    int narrow = 0;
    for (std::size_t i = 0; i < clusters.items.size(); ++i) {
      const model::Cluster& item = clusters.items[i];
      const model::Cluster& group = clusters.groups[i / most];
      QVERIFY(glm::distance(item.bounds.centre, group.bounds.centre) + item.bounds.radius <=
              group.bounds.radius);
      QVERIFY(group.candidateTriangles >= item.candidateTriangles);
      narrow += group.cone.cosine > 0.0f;
      for (std::uint32_t k = 0; k < item.vertexCount; ++k) {
        const model::SurfaceVertex& v = surface->vertices[clusters.vertices[item.firstVertex + k]];
        if (group.cone.cosine > -1.0f)
          QVERIFY(glm::dot(v.normal, group.cone.axis) >= group.cone.cosine);
        if (k >= item.candidateVertices)
          continue;
        const std::array<float, 6> s = model::shapeOperator(v);
        float squared = 0.0f;
        for (std::size_t c = 0; c < 6; ++c) {
          const float difference = s[c] - group.tensorBounds.middle[c];
          squared += (c == 0 || c == 3 || c == 5 ? 1.0f : 2.0f) * difference * difference;
        }
        QVERIFY(std::sqrt(squared) <= group.tensorBounds.spread + 1e-6f);
        QVERIFY(std::max(std::abs(v.k.x), std::abs(v.k.y)) <= group.tensorBounds.largest);
      }
    }
    QVERIFY2(narrow > 0, "the cones decide nothing");
  }

 private:
  static float sample(const model::Clusters& clusters, std::size_t at) {
    return float(clusters.samples[at]) - model::Clusters::mostSteps;
  }

  static void checkPlace(const model::Surface& surface, const model::Cluster& cluster,
                         std::uint32_t vertex) {
    const model::Clusters& clusters = surface.clusters;
    const model::SurfaceVertex& v =
        surface.vertices[clusters.vertices[cluster.firstVertex + vertex]];
    const float place = cluster.bounds.radius / model::Clusters::mostSteps;
    for (glm::length_t a = 0; a < 3; ++a) {
      const std::size_t at = cluster.firstSample + std::size_t(a) * cluster.vertexCount + vertex;
      QVERIFY(std::abs(cluster.bounds.centre[a] + place * sample(clusters, at) - v.position[a]) <=
              0.501f * place);
      QVERIFY(std::abs(cluster.cone.axis[a] +
                       cluster.normalStep *
                           sample(clusters, at + std::size_t(3) * cluster.vertexCount) -
                       v.normal[a]) <= 0.501f * cluster.normalStep + 1e-6f);
    }
  }

  static void checkBending(const model::Surface& surface, const model::Cluster& cluster,
                           std::uint32_t vertex) {
    const model::Clusters& clusters = surface.clusters;
    const model::TensorBounds& bounds = cluster.tensorBounds;
    const model::SurfaceVertex& v =
        surface.vertices[clusters.vertices[cluster.firstVertex + vertex]];
    const std::array<float, 6> s = model::shapeOperator(v);
    const std::size_t first =
        cluster.firstSample + model::Clusters::placeRows * cluster.vertexCount;
    float squared = 0.0f;
    for (std::size_t c = 0; c < 6; ++c) {
      const std::size_t at = first + c * cluster.candidateVertices + vertex;
      QVERIFY(std::abs(bounds.middle[c] + bounds.step * sample(clusters, at) - s[c]) <=
              0.501f * bounds.step + 1e-6f * bounds.largest);
      const float difference = s[c] - bounds.middle[c];
      squared += (c == 0 || c == 3 || c == 5 ? 1.0f : 2.0f) * difference * difference;
    }
    QVERIFY(std::sqrt(squared) <= 1.001f * bounds.spread + 1e-6f);
    QVERIFY(std::max(std::abs(v.k.x), std::abs(v.k.y)) <= bounds.largest);
  }
};

SLINE_TEST(ClustersTest)
#include "clusters_test.moc"
