// SPDX-License-Identifier: Apache-2.0
// Compares what lines a pocket with a plane and a ball, where the answer is a disc and nothing.
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/import/molecules/surface/pocket_lining.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Returns a square of side 40 about the origin at height z, facing up or down.
TriangleMesh sheet(float z, bool up) {
  constexpr std::uint32_t cells = 80;
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= cells; ++y)
    for (std::uint32_t x = 0; x <= cells; ++x)
      mesh.positions.emplace_back(0.5f * float(x) - 20.0f, 0.5f * float(y) - 20.0f, z);
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t i = y * (cells + 1) + x;
      const std::uint32_t above = i + cells + 1;
      mesh.triangles.push_back(up ? Triangle{i, i + 1, above + 1} : Triangle{i, above + 1, i + 1});
      mesh.triangles.push_back(up ? Triangle{i, above + 1, above} : Triangle{i, above, above + 1});
    }
  return mesh;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3& a = mesh.positions[t[0]];
    area +=
        0.5 * double(glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)));
  }
  return area;
}

}  // namespace

class TestPocketLining : public QObject {
  Q_OBJECT

 private slots:
  /// A guest above a plane: what is within reach is a disc, by Pythagoras.
  void disc() {
    const glm::vec3 guest(0.0f, 0.0f, 3.0f);
    const TriangleMesh lining = pocketLining(sheet(0.0f, true), {&guest, 1}, 5.0f);
    const double expected = std::numbers::pi * (25.0 - 9.0);
    QVERIFY(std::abs(areaOf(lining) / expected - 1.0) < 0.12);
    for (const glm::vec3& p : lining.positions) {
      QVERIFY(p.z > 0.0f && p.z < 0.2f);  // raised towards the guest
      QVERIFY(std::hypot(p.x, p.y) < 4.3f);
    }
    // The edge is a circle, not the outline of triangles.
    float nearest = 10.0f;
    for (const glm::vec3& p : lining.positions)
      if (std::hypot(p.x, p.y) > 3.8f)
        nearest = std::min(nearest, std::hypot(p.x, p.y));
    QVERIFY(nearest < 4.2f);
  }
  void aWallsFarSideIsNoLining() {
    const glm::vec3 guest(0.0f, 0.0f, 3.0f);
    QVERIFY(pocketLining(sheet(0.0f, false), {&guest, 1}, 5.0f).triangles.empty());
  }
  void nothingNear() {
    const glm::vec3 guest(0.0f, 0.0f, 30.0f);
    QVERIFY(pocketLining(sheet(0.0f, true), {&guest, 1}, 5.0f).triangles.empty());
    QVERIFY(pocketLining(sheet(0.0f, true), {}, 5.0f).positions.empty());
    QVERIFY(pocketLining({}, {&guest, 1}, 5.0f).positions.empty());
  }
};

SLINE_TEST(TestPocketLining)
#include "test_pocket_lining.moc"
