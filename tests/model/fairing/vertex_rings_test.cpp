// SPDX-License-Identifier: Apache-2.0
// Tests that all vertices are visited with their rings, however long these are.
#include "model/fairing/vertex_rings.h"

#include <QtTest>
#include <set>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
/// Returns fans of 2 to 40 triangles, each around a vertex of its own, and vertices without any.
std::vector<Triangle> fans(std::uint32_t& vertexCount) {
  std::vector<Triangle> triangles;
  vertexCount = 3;
  for (std::uint32_t blades = 2; blades <= 40; ++blades) {
    const std::uint32_t middle = vertexCount++;
    const std::uint32_t rim = vertexCount;
    vertexCount += blades + 1;
    for (std::uint32_t blade = 0; blade < blades; ++blade)
      triangles.push_back({middle, rim + blade, rim + blade + 1});
    ++vertexCount;
  }
  return triangles;
}

struct Visited {
  std::vector<int> times;
  std::vector<std::set<std::uint32_t>> rings;
};

Visited visited(const VertexRings& rings) {
  Visited result{std::vector<int>(rings.vertexCount(), 0),
                 std::vector<std::set<std::uint32_t>>(rings.vertexCount())};
  rings.forEach([&](std::size_t v, const auto& ring) {
    ++result.times[v];
    result.rings[v].insert(ring.begin(), ring.end());
  });
  return result;
}
}  // namespace

class VertexRingsTest : public QObject {
  Q_OBJECT
 private slots:
  void eachVertexOnceWithItsRing_data() {
    QTest::addColumn<bool>("ball");
    QTest::newRow("fans") << false;
    QTest::newRow("a ball of more vertices than a block") << true;
  }
  void eachVertexOnceWithItsRing() {
    QFETCH(bool, ball);
    std::uint32_t count = 0;
    std::vector<Triangle> triangles = fans(count);
    if (ball) {
      const MeshPtr mesh = test::sphere(10.0f, 5);
      triangles.assign(mesh->triangles().begin(), mesh->triangles().end());
      count = std::uint32_t(mesh->vertexCount());
      QVERIFY(count > 4000);
    }
    const VertexRings rings(count, triangles, HalfEdges(count, triangles));
    const Visited result = visited(rings);
    std::vector<std::set<std::uint32_t>> known(count);
    for (const Triangle& t : triangles)
      for (std::size_t c = 0; c < 3; ++c)
        known[t[c]].insert({t[(c + 1) % 3], t[(c + 2) % 3]});
    for (std::size_t v = 0; v < count; ++v) {
      QCOMPARE(result.times[v], 1);
      QVERIFY(result.rings[v] == known[v]);
      QVERIFY(rings[v].size() == known[v].size());
    }
  }
};

SLINE_TEST(VertexRingsTest)
#include "vertex_rings_test.moc"
