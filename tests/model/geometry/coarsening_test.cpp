// SPDX-License-Identifier: Apache-2.0
// Tests that levels of detail keep a surface's form and connectivity.
#include "model/geometry/coarsening.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <tuple>

#include "model/geometry/bvh.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/spatial_order.h"
#include "model/geometry/topology.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using model::Mesh;
using model::MeshPtr;

namespace {

float meanEdge(const Mesh& mesh) {
  return model::meanEdgeLength(mesh.positions(), mesh.triangles());
}

long eulerNumber(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const model::Triangle& t : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  return long(mesh.vertexCount()) - long(edges.size()) + long(mesh.triangleCount());
}

float longestOf(const Mesh& mesh) {
  float longest = 0.0f;
  for (const model::Triangle& t : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i)
      longest =
          std::max(longest, glm::length(mesh.positions()[t[i]] - mesh.positions()[t[(i + 1) % 3]]));
  return longest;
}

std::set<std::tuple<float, float, float>> places(const Mesh& mesh) {
  std::set<std::tuple<float, float, float>> all;
  for (const glm::vec3& p : mesh.positions())
    all.insert({p.x, p.y, p.z});
  return all;
}

/// Returns the largest distance of a vertex of `mesh` from the surface of `other`.
float farthestOf(const Mesh& mesh, const MeshPtr& other) {
  const model::Bvh tree(other, model::spatialOrder(*other));
  float farthest = 0.0f;
  for (const glm::vec3& p : mesh.positions())
    farthest = std::max(farthest, tree.closest(p).distance);
  return farthest;
}

/// A torus with waves all over it.
MeshPtr wavyTorus(int aroundRing, int aroundTube) {
  const MeshPtr smooth = test::torus(50.0f, 20.0f, aroundRing, aroundTube);
  std::vector<glm::vec3> positions(smooth->positions().begin(), smooth->positions().end());
  for (glm::vec3& p : positions)
    p += 0.4f * glm::vec3(std::sin(0.5f * p.y), std::sin(0.4f * p.z), std::sin(0.6f * p.x));
  const auto triangles = smooth->triangles();
  return std::make_shared<const Mesh>(
      std::move(*Mesh::create(std::move(positions), {triangles.begin(), triangles.end()})));
}

}  // namespace

class CoarseningTest : public QObject {
  Q_OBJECT
 private slots:
  void closedSurfacesKeepTheirForm_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::newRow("torus with waves") << wavyTorus(600, 240);
    QTest::newRow("sphere") << test::sphere(30.0f, 7);
    QTest::newRow("two of them") << test::together(*test::sphere(30.0f, 6),
                                                   *test::torus(80.0f, 20.0f, 500, 200));
  }

  void closedSurfacesKeepTheirForm() {
    QFETCH(MeshPtr, mesh);
    const float edge = 1.6f * meanEdge(*mesh);
    const MeshPtr coarse = model::coarsened(*mesh, edge).mesh;
    QVERIFY2(float(coarse->triangleCount()) < 0.4f * float(mesh->triangleCount()),
             qPrintable(QString::number(coarse->triangleCount())));
    QVERIFY(model::countEdges(*coarse, model::VertexFaces(*coarse)).closed());
    QCOMPARE(eulerNumber(*coarse), eulerNumber(*mesh));
    QVERIFY(longestOf(*coarse) <= 1.8f * edge);
    const auto before = places(*mesh);
    const auto after = places(*coarse);
    QCOMPARE(after.size(), coarse->vertexCount());
    QVERIFY(std::includes(before.begin(), before.end(), after.begin(), after.end()));
    QVERIFY2(farthestOf(*mesh, coarse) <= 0.2f * edge,
             qPrintable(QString::number(farthestOf(*mesh, coarse) / edge)));
  }

  void levelsFollowEachOther() {
    MeshPtr mesh = wavyTorus(600, 240);
    for (int level = 0; level < 3; ++level) {
      const MeshPtr coarser = model::coarsened(*mesh, 1.6f * meanEdge(*mesh)).mesh;
      QVERIFY(coarser->triangleCount() < mesh->triangleCount() / 2);
      QVERIFY(meanEdge(*coarser) > 1.5f * meanEdge(*mesh));
      QCOMPARE(eulerNumber(*coarser), 0L);
      mesh = coarser;
    }
  }

  void theSameMeshGivesTheSame() {
    const MeshPtr mesh = wavyTorus(300, 120);
    const float edge = 2.0f * meanEdge(*mesh);
    QVERIFY(*model::coarsened(*mesh, edge).mesh == *model::coarsened(*mesh, edge).mesh);
  }

  void rimsStay() {
    const MeshPtr tube = test::cylinder(20.0f, 60.0f, 400, 200);
    const MeshPtr coarse = model::coarsened(*tube, 2.0f * meanEdge(*tube)).mesh;
    QVERIFY(coarse->triangleCount() < tube->triangleCount() / 2);
    const auto rims = [](const Mesh& mesh) {
      return model::countEdges(mesh, model::VertexFaces(mesh)).open;
    };
    QCOMPARE(rims(*coarse), rims(*tube));
    QCOMPARE(eulerNumber(*coarse), eulerNumber(*tube));
  }

  /// What is no fan stays where it is: very many triangles at one vertex, three at one edge,
  /// triangles of no size.
  void oddPlacesStay() {
    std::vector<glm::vec3> positions{{0, 0, 0}, {0, 0, 1}};
    std::vector<model::Triangle> triangles;
    constexpr std::uint32_t around = 40;
    for (std::uint32_t i = 0; i < around; ++i) {
      const float at = 6.2831853f * float(i) / float(around);
      positions.emplace_back(std::cos(at), std::sin(at), 0.5f);
      const std::uint32_t next = 2 + (i + 1) % around;
      triangles.push_back({1, 2 + i, next});
      triangles.push_back({0, next, 2 + i});
    }
    triangles.push_back({0, 1, 2});  // a fin
    triangles.push_back({3, 3, 4});  // of no size
    const auto odd = std::make_shared<const Mesh>(*Mesh::create(positions, triangles));
    const MeshPtr coarse = model::coarsened(*odd, 5.0f).mesh;
    QVERIFY(coarse->triangleCount() < odd->triangleCount());
    const auto left = places(*coarse);
    for (const std::size_t v : {0, 1, 2, 3, 4})
      QVERIFY(left.contains({positions[v].x, positions[v].y, positions[v].z}));
  }

  /// Triangles without order: some share vertices, or all of them, and some have no size.
  void soupsAreNoTrouble() {
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return std::uint32_t(random() % n); };
    for (int round = 0; round < 300; ++round) {
      std::vector<glm::vec3> positions(3 + below(60));
      for (glm::vec3& p : positions)
        p = {float(below(100)), float(below(100)), round % 3 ? float(below(100)) : 0.0f};
      std::vector<model::Triangle> triangles(1 + below(200));
      for (model::Triangle& t : triangles)
        for (std::uint32_t& corner : t)
          corner = below(positions.size());
      const auto soup = std::make_shared<const Mesh>(*Mesh::create(positions, triangles));
      for (const float edge : {5.0f, 50.0f, 500.0f})
        if (const MeshPtr coarse = model::coarsened(*soup, edge).mesh)
          QVERIFY(coarse->triangleCount() < soup->triangleCount());
    }
  }

  void verticesAreSomeOfTheFinerOnes() {
    const MeshPtr mesh = wavyTorus(300, 120);
    const model::CoarserMesh coarse = model::coarsened(*mesh, 1.6f * meanEdge(*mesh));
    QCOMPARE(coarse.vertices.size(), coarse.mesh->vertexCount());
    for (std::size_t v = 0; v < coarse.vertices.size(); ++v)
      QVERIFY(coarse.mesh->positions()[v] == mesh->positions()[coarse.vertices[v]]);
  }

  void coarseMeshesAreTheirOwn() {
    const MeshPtr mesh = test::sphere(30.0f, 3);
    QVERIFY(!model::coarsened(*mesh, 0.1f * meanEdge(*mesh)).mesh);
    const auto none = std::make_shared<const Mesh>(*Mesh::create({}, {}));
    QVERIFY(!model::coarsened(*none, 1.0f).mesh);
  }
};

SLINE_TEST(CoarseningTest)
#include "coarsening_test.moc"
