// SPDX-License-Identifier: Apache-2.0
// Tests that what is painted on a mesh is found again on another mesh of the same thing.
#include "model/geometry/paint.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

constexpr float radius = 20.0f;

/// Paints the cap around +z, softly.
float capAt(const glm::vec3& p) {
  return std::clamp((p.z / radius - 0.5f) / 0.2f, 0.0f, 1.0f);
}

Paint capOn(const Mesh& mesh) {
  Paint paint;
  for (const glm::vec3& p : mesh.positions())
    paint.push_back(std::uint8_t(std::lround(255.0f * capAt(p))));
  return paint;
}

/// Returns the mesh with its vertices and triangles in another order.
MeshPtr renumbered(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertexCount());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(7);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<glm::vec3> positions(order.size());
  for (std::size_t v = 0; v < order.size(); ++v)
    positions[order[v]] = mesh.positions()[v];
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t)
      v = order[v];
  std::shuffle(triangles.begin(), triangles.end(), random);
  return std::make_shared<const Mesh>(*Mesh::create(std::move(positions), std::move(triangles)));
}

/// Returns the farthest that a value lies from the cap, 0 … 1.
float fault(const Mesh& mesh, const Paint& paint) {
  float most = 0.0f;
  for (std::size_t v = 0; v < paint.size(); ++v)
    most = std::max(most, std::abs(float(paint[v]) / 255.0f - capAt(mesh.positions()[v])));
  return most;
}

}  // namespace

class PaintTest : public QObject {
  Q_OBJECT
 private slots:
  void ofTheSameMeshIsTheSame();
  void otherNumbersKeepEachValue();
  void fewerAndMoreVerticesKeepTheRegion();
  void whatIsGoneIsCounted();
  void elsewhereNothingIsLeft();
};

void PaintTest::ofTheSameMeshIsTheSame() {
  const MeshPtr mesh = test::sphere(radius, 3);
  const Paint paint = capOn(*mesh);
  const CarriedPaint carried = carriedPaint(mesh, paint, mesh);
  QVERIFY(carried.paint && *carried.paint == paint);
  QCOMPARE(carried.lost, 0.0f);
  QVERIFY(!carriedPaint(mesh, Paint(mesh->vertexCount(), 0), mesh).paint);
}

void PaintTest::otherNumbersKeepEachValue() {
  const MeshPtr mesh = test::sphere(radius, 3);
  const MeshPtr other = renumbered(*mesh);
  const CarriedPaint carried = carriedPaint(mesh, capOn(*mesh), other);
  QVERIFY(carried.paint);
  QVERIFY(*carried.paint == capOn(*other));
  QVERIFY(*carried.paint != capOn(*mesh));  // the order is another one indeed
  QCOMPARE(carried.lost, 0.0f);
}

void PaintTest::fewerAndMoreVerticesKeepTheRegion() {
  const MeshPtr fine = test::sphere(radius, 5);
  const MeshPtr coarse = test::sphere(radius, 3);
  for (const auto& [from, to] : {std::pair{fine, coarse}, std::pair{coarse, fine}}) {
    const CarriedPaint carried = carriedPaint(from, capOn(*from), to);
    QVERIFY(carried.paint);
    QCOMPARE(carried.lost, 0.0f);
    const float most = fault(*to, *carried.paint);
    QVERIFY2(most < 0.2f, std::to_string(most).c_str());  // a coarse edge takes as much of the rim
  }
}

void PaintTest::whatIsGoneIsCounted() {
  const MeshPtr mesh = test::sphere(radius, 4);
  // Half of the sphere: x > 0 alone.
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh->triangles())
    if (mesh->positions()[t[0]].x > 0.0f)
      kept.push_back(t);
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> now(mesh->vertexCount(), std::uint32_t(-1));
  for (Triangle& t : kept)
    for (std::uint32_t& v : t) {
      if (now[v] == std::uint32_t(-1)) {
        now[v] = std::uint32_t(positions.size());
        positions.push_back(mesh->positions()[v]);
      }
      v = now[v];
    }
  const auto half =
      std::make_shared<const Mesh>(*Mesh::create(std::move(positions), std::move(kept)));
  const CarriedPaint carried = carriedPaint(mesh, capOn(*mesh), half);
  QVERIFY(carried.paint);
  QVERIFY(fault(*half, *carried.paint) < 0.02f);
  QVERIFY2(carried.lost > 0.35f && carried.lost < 0.5f, std::to_string(carried.lost).c_str());
}

void PaintTest::elsewhereNothingIsLeft() {
  const MeshPtr mesh = test::sphere(radius, 3);
  const MeshPtr away = test::moved(*mesh, 1.0f, {100.0f, 0.0f, 0.0f});
  const CarriedPaint carried = carriedPaint(mesh, capOn(*mesh), away);
  QVERIFY(!carried.paint);
  QCOMPARE(carried.lost, 1.0f);
}

SLINE_TEST(PaintTest)
#include "paint_test.moc"
