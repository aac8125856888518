// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/simplification.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "model/geometry/topology.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using model::MeshPtr;

namespace {
MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<model::Triangle> triangles) {
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions), std::move(triangles))).value());
}

/// Returns a closed slab of 80 × 80 × 10 mm with vertices that are off by up to 0.05 mm.
MeshPtr noisySlab() {
  const MeshPtr ball = test::sphere(1.0f, 4);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> off(-0.05f, 0.05f);
  std::vector<glm::vec3> positions;
  for (const glm::vec3& p : ball->positions())
    positions.push_back(glm::vec3(40.0f * p.x, 40.0f * p.y, 5.0f * std::tanh(6.0f * p.z)) +
                        glm::vec3(off(random), off(random), off(random)));
  return meshOf(std::move(positions), {ball->triangles().begin(), ball->triangles().end()});
}

/// Returns three leaves that meet in one edge, each of many triangles.
MeshPtr book() {
  constexpr int cells = 12;
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  for (int z = 0; z <= cells; ++z)
    positions.emplace_back(0.0f, 0.0f, float(z));
  for (int leaf = 0; leaf < 3; ++leaf) {
    const auto at = [&, first = std::uint32_t(positions.size())](int x, int z) {
      return x == 0 ? std::uint32_t(z) : first + std::uint32_t((x - 1) * (cells + 1) + z);
    };
    const float angle = 2.1f * float(leaf);
    for (int x = 1; x <= cells; ++x)
      for (int z = 0; z <= cells; ++z)
        positions.emplace_back(float(x) * std::cos(angle), float(x) * std::sin(angle), float(z));
    for (int x = 0; x < cells; ++x)
      for (int z = 0; z < cells; ++z) {
        triangles.push_back({at(x, z), at(x + 1, z), at(x + 1, z + 1)});
        triangles.push_back({at(x, z), at(x + 1, z + 1), at(x, z + 1)});
      }
  }
  return meshOf(std::move(positions), std::move(triangles));
}

/// Returns two quilted sheets, 0.2 mm apart except at each third vertex, which they share.
MeshPtr quilt() {
  constexpr int cells = 30;
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  std::map<std::array<int, 2>, std::uint32_t> stitches;
  for (const float side : {0.1f, -0.1f}) {
    std::map<std::array<int, 2>, std::uint32_t> at;
    for (int x = 0; x <= cells; ++x)
      for (int y = 0; y <= cells; ++y) {
        const std::array<int, 2> place{x, y};
        const bool stitched = x % 3 == 1 && y % 3 == 1;
        if (stitched && stitches.contains(place)) {
          at[place] = stitches[place];
          continue;
        }
        at[place] = std::uint32_t(positions.size());
        if (stitched)
          stitches[place] = at[place];
        positions.emplace_back(float(x), float(y), stitched ? 0.0f : side);
      }
    for (int x = 0; x < cells; ++x)
      for (int y = 0; y < cells; ++y) {
        const auto corner = [&](int i, int j) { return at[{x + i, y + j}]; };
        model::Triangle lower{corner(0, 0), corner(1, 0), corner(1, 1)};
        model::Triangle upper{corner(0, 0), corner(1, 1), corner(0, 1)};
        if (side < 0.0f) {
          std::swap(lower[1], lower[2]);
          std::swap(upper[1], upper[2]);
        }
        triangles.insert(triangles.end(), {lower, upper});
      }
  }
  return meshOf(std::move(positions), std::move(triangles));
}

/// Returns a ball with one half inside out.
MeshPtr halfTurned() {
  const MeshPtr ball = test::sphere(20, 4);
  std::vector<model::Triangle> triangles(ball->triangles().begin(), ball->triangles().end());
  for (model::Triangle& t : triangles)
    if (ball->positions()[t[0]].z + ball->positions()[t[1]].z + ball->positions()[t[2]].z > 0.0f)
      std::swap(t[1], t[2]);
  return meshOf({ball->positions().begin(), ball->positions().end()}, std::move(triangles));
}

/// Returns two balls with one vertex in common.
MeshPtr touchingBalls() {
  const MeshPtr ball = test::sphere(20, 4);
  const auto ends =
      std::minmax_element(ball->positions().begin(), ball->positions().end(),
                          [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; });
  const auto last = std::uint32_t(ends.second - ball->positions().begin());
  const auto first = std::uint32_t(ends.first - ball->positions().begin());
  const auto count = std::uint32_t(ball->vertexCount());
  std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
  std::vector<model::Triangle> triangles(ball->triangles().begin(), ball->triangles().end());
  for (const glm::vec3& p : ball->positions())
    positions.push_back(p + (*ends.second - *ends.first));
  for (model::Triangle t : ball->triangles()) {
    for (std::uint32_t& v : t)
      v = v == first ? last : v + count;
    triangles.push_back(t);
  }
  return meshOf(std::move(positions), std::move(triangles));
}

/// Returns the number of pairs of triangles that disagree at their edge about which side is
/// outside.
std::size_t disagreements(const model::Mesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> seen;
  for (const model::Triangle& t : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k)
      ++seen[{t[k], t[(k + 1) % 3]}];
  return std::size_t(
      std::count_if(seen.begin(), seen.end(), [](const auto& edge) { return edge.second == 2; }));
}

double distanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double t = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
  return glm::distance(p, a + std::min(1.0, std::max(0.0, t)) * (b - a));
}

/// Returns the distance found by trying every triangle, in double precision.
double distanceByForce(const model::Mesh& mesh, const glm::vec3& point) {
  double best = 1e30;
  const glm::dvec3 p = point;
  for (const auto& [i, j, k] : mesh.triangles()) {
    const glm::dvec3 a = mesh.positions()[i];
    const glm::dvec3 b = mesh.positions()[j];
    const glm::dvec3 c = mesh.positions()[k];
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const bool inside = glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
                        glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
                        glm::dot(glm::cross(a - c, p - c), n) >= 0;
    best = std::min(best, inside ? std::abs(glm::dot(p - a, n))
                                 : std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c),
                                             distanceToSegment(p, c, a)}));
  }
  return best;
}

/// Returns how far the second surface is, at most, from points drawn at random on the first.
double farthestByForce(const model::Mesh& from, const model::Mesh& to) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> triangle(0, from.triangleCount() - 1);
  std::uniform_real_distribution<float> weight(0.0f, 1.0f);
  double most = 0.0;
  for (int i = 0; i < 150; ++i) {
    const auto& [a, b, c] = from.triangles()[triangle(random)];
    float u = weight(random);
    float v = weight(random);
    if (u + v > 1.0f) {
      u = 1.0f - u;
      v = 1.0f - v;
    }
    const auto p = from.positions();
    most = std::max(most, distanceByForce(to, p[a] + u * (p[b] - p[a]) + v * (p[c] - p[a])));
  }
  return most;
}

double volume(const model::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles())
    sum += glm::dot(glm::dvec3(mesh.positions()[a]),
                    glm::cross(glm::dvec3(mesh.positions()[b]), glm::dvec3(mesh.positions()[c])));
  return sum / 6.0;
}

/// Returns vertices − edges + triangles: 2 for a ball, 0 for a ring. Vertices without triangles do
/// not count.
int eulerOf(const model::Mesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const model::Triangle& t : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = t[(k + 1) % 3];
      vertices.insert(next);
      edges.insert({std::min(t[k], next), std::max(t[k], next)});
    }
  return int(vertices.size()) - int(edges.size()) + int(mesh.triangleCount());
}

model::EdgeCount edgesOf(const model::Mesh& mesh) {
  return model::countEdges(mesh, model::VertexFaces(mesh));
}

bool always() {
  return true;
}
}  // namespace

Q_DECLARE_METATYPE(sline::model::MeshPtr)

class SimplificationTest : public QObject {
  Q_OBJECT
 private slots:
  void closed_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::addColumn<float>("bound");
    QTest::addColumn<int>("times");  // least factor of fewer triangles
    // Triangles with their middle s from a sphere of radius R have edges of about √(6·R·s).
    QTest::newRow("ball") << test::sphere(50, 4) << 0.8f << 8;
    QTest::newRow("ball, fine") << test::sphere(50, 4) << 0.3f << 2;
    QTest::newRow("ring") << test::torus(40, 10, 120, 40) << 0.3f << 5;
    QTest::newRow("noisy slab") << noisySlab() << 0.25f << 8;
    QTest::newRow("two balls") << test::together(*test::sphere(20, 3),
                                                 *test::moved(*test::sphere(20, 3), 1, {60, 0, 0}))
                               << 0.5f << 2;
  }
  void closed() {
    QFETCH(MeshPtr, mesh);
    QFETCH(float, bound);
    QFETCH(int, times);
    const model::Simplified fewer = model::simplified(mesh, bound, always);
    QVERIFY(fewer.mesh != mesh);
    QVERIFY2(fewer.mesh->triangleCount() * std::size_t(times) < mesh->triangleCount(),
             qPrintable(QString::number(fewer.mesh->triangleCount())));
    QVERIFY(fewer.error > 0.0f && fewer.error <= bound);
    const double there = farthestByForce(*fewer.mesh, *mesh);
    const double back = farthestByForce(*mesh, *fewer.mesh);
    QVERIFY2(std::max(there, back) < 1.05 * double(bound),
             qPrintable(QString("%1 %2").arg(there).arg(back)));
    // Points between the samples cannot be far beyond them.
    QVERIFY(std::max(there, back) < 1.2 * double(fewer.error));
    QVERIFY(edgesOf(*fewer.mesh).closed());
    QCOMPARE(eulerOf(*fewer.mesh), eulerOf(*mesh));
    QCOMPARE(model::connectedComponents(*fewer.mesh).count,
             model::connectedComponents(*mesh).count);
    QVERIFY(std::abs(volume(*fewer.mesh) / volume(*mesh) - 1.0) < 0.03);
    // A second run gives the same, bit for bit.
    QVERIFY(*model::simplified(mesh, bound, always).mesh == *fewer.mesh);
  }

  void rimsStay_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::newRow("bowl") << test::paraboloid(0.02f, 0.02f, 20, 40);
    QTest::newRow("tube") << test::cylinder(10, 60, 64, 60);
    QTest::newRow("three leaves at one edge") << book();
  }
  void rimsStay() {
    QFETCH(MeshPtr, mesh);
    const model::Simplified fewer = model::simplified(mesh, 0.2f, always);
    QVERIFY(fewer.mesh->triangleCount() * 3 < mesh->triangleCount() * 2);
    QVERIFY(fewer.error <= 0.2f);
    const model::EdgeCount before = edgesOf(*mesh);
    const model::EdgeCount after = edgesOf(*fewer.mesh);
    QCOMPARE(after.open, before.open);
    QCOMPARE(after.nonManifold, before.nonManifold);
    const double rim = model::rimLength(*mesh, model::VertexFaces(*mesh));
    QVERIFY(std::abs(model::rimLength(*fewer.mesh, model::VertexFaces(*fewer.mesh)) - rim) < 1e-3);
  }

  /// Parts that a half-edge structure cannot hold are cut open on the way and whole again
  /// afterwards.
  void cutsHeal_data() {
    QTest::addColumn<MeshPtr>("mesh");
    QTest::addColumn<int>("pieces");
    QTest::newRow("two balls that touch") << touchingBalls() << 1;
    QTest::newRow("half inside out") << halfTurned() << 1;
    QTest::newRow("two sheets, quilted") << quilt() << 1;
  }
  void cutsHeal() {
    QFETCH(MeshPtr, mesh);
    QFETCH(int, pieces);
    const model::Simplified fewer = model::simplified(mesh, 0.5f, always);
    QVERIFY2(fewer.mesh->triangleCount() * 3 < mesh->triangleCount() * 2,
             qPrintable(QString::number(fewer.mesh->triangleCount())));
    QVERIFY(fewer.error <= 0.5f);
    const model::EdgeCount before = edgesOf(*mesh);
    const model::EdgeCount after = edgesOf(*fewer.mesh);
    QCOMPARE(after.open, before.open);
    QCOMPARE(after.nonManifold, before.nonManifold);
    QCOMPARE(disagreements(*fewer.mesh), disagreements(*mesh));
    QCOMPARE(int(model::connectedComponents(*mesh).count), pieces);
    QCOMPARE(int(model::connectedComponents(*fewer.mesh).count), pieces);
    QCOMPARE(eulerOf(*fewer.mesh), eulerOf(*mesh));
  }

  /// The sheets are sewn to themselves at random, with some triangles turned and some there twice.
  void sewnSheets() {
    std::mt19937 random(5);
    const auto below = [&](std::size_t n) { return std::uint32_t(random() % n); };
    int simplified = 0;
    for (int sheet = 0; sheet < 200; ++sheet) {
      const MeshPtr flat = test::paraboloid(0.001f, 0.001f, 10, int(4 + below(8)));
      std::vector<model::Triangle> triangles(flat->triangles().begin(), flat->triangles().end());
      for (std::uint32_t seams = below(6); seams > 0; --seams) {
        const std::uint32_t from = below(flat->vertexCount());
        const std::uint32_t to = below(flat->vertexCount());
        for (model::Triangle& t : triangles)
          std::replace(t.begin(), t.end(), from, to);
      }
      for (std::uint32_t turned = below(4); turned > 0; --turned) {
        model::Triangle& t = triangles[below(triangles.size())];
        std::swap(t[0], t[1]);
      }
      for (std::uint32_t twice = below(3); twice > 0; --twice)
        triangles.push_back(triangles[below(triangles.size())]);
      const MeshPtr sewn = meshOf({flat->positions().begin(), flat->positions().end()}, triangles);
      const MeshPtr fewer = model::simplified(sewn, 2.0f, always).mesh;
      simplified += fewer != sewn ? 1 : 0;
      QCOMPARE(edgesOf(*fewer).open, edgesOf(*sewn).open);
      QCOMPARE(edgesOf(*fewer).nonManifold, edgesOf(*sewn).nonManifold);
      QCOMPARE(disagreements(*fewer), disagreements(*sewn));
    }
    QVERIFY(simplified > 100);
  }

  void nothingToDo() {
    const MeshPtr ball = test::sphere(50, 3);
    QVERIFY(model::simplified(ball, 0.0f, always).mesh == ball);
    QVERIFY(model::simplified(ball, 1.0f, [] { return false; }).mesh == ball);
    QVERIFY(model::simplified(ball, 1e-6f, always).mesh == ball);
    const MeshPtr nothing = meshOf({}, {});
    QVERIFY(model::simplified(nothing, 1.0f, always).mesh == nothing);
    // A tetrahedron has no edge to spare, however generous the bound.
    const MeshPtr least = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    QVERIFY(model::simplified(least, 100.0f, always).mesh == least);
  }

  void brokenMeshes() {
    // There are triangles without area and with one vertex twice, and a vertex where two cones
    // touch.
    const MeshPtr odd = meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0}},
                               {{0, 1, 2}, {0, 0, 1}, {0, 1, 3}, {4, 4, 4}, {0, 1, 3}});
    const model::Simplified same = model::simplified(odd, 10.0f, always);
    QCOMPARE(same.mesh->triangleCount(), odd->triangleCount());
  }
};

SLINE_TEST(SimplificationTest)
#include "simplification_test.moc"
