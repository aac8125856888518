// SPDX-License-Identifier: Apache-2.0
// Tests where an open surface ends.
#include "render/lines/techniques/rims.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/lines/techniques/lines.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {
namespace {

std::vector<Segment> rimsOf(const model::MeshPtr& mesh) {
  const model::SurfacePtr surface = model::prepareSurface(mesh);
  const auto prepared = prepareRims(*surface);
  std::vector<Segment> segments;
  const model::Camera camera;
  const LineRequest request;
  findRims({*surface, camera, request, prepared.get()}, segments);
  return segments;
}

/// Returns the tube cut open along its length: the two sides lie at the same place, unjoined.
model::MeshPtr slit(const model::Mesh& tube) {
  std::vector<glm::vec3> positions(tube.positions().begin(), tube.positions().end());
  std::vector<model::Triangle> triangles(tube.triangles().begin(), tube.triangles().end());
  const std::size_t count = positions.size();
  for (std::size_t v = 0; v < count; ++v)
    positions.push_back(positions[v]);
  for (model::Triangle& t : triangles) {
    const glm::vec3 middle = (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0f;
    if (middle.x > 0.0f)
      for (std::uint32_t& corner : t)
        corner += std::uint32_t(count);
  }
  auto mesh = model::Mesh::create(std::move(positions), std::move(triangles));
  return mesh.ok() ? std::make_shared<const model::Mesh>(std::move(*mesh)) : nullptr;
}

double lengthOf(const std::vector<Segment>& segments) {
  double length = 0.0;
  for (const Segment& s : segments)
    length += double(glm::distance(s.a, s.b));
  return length;
}

}  // namespace

class RimsTest : public QObject {
  Q_OBJECT

 private slots:
  void closedSurfacesHaveNone() { QVERIFY(rimsOf(test::torus(50.0f, 20.0f, 60, 24)).empty()); }

  /// The two ends of a tube, from where it would go on along its length.
  void tubesEndTwice() {
    constexpr float radius = 20.0f;
    constexpr float height = 90.0f;
    const std::vector<Segment> rims = rimsOf(test::cylinder(radius, height, 64, 20));
    const double around = 2.0 * std::numbers::pi * double(radius);
    QVERIFY(std::abs(lengthOf(rims) - 2.0 * around) < 0.01 * around);
    for (const Segment& s : rims) {
      QCOMPARE(std::abs(s.a.z), 0.5f * height);
      QCOMPARE(s.a.z, s.b.z);
      const glm::vec3 outwards(0.0f, 0.0f, s.a.z > 0.0f ? 1.0f : -1.0f);
      QVERIFY(glm::distance(s.normalA, outwards) < 1e-3f);
      QVERIFY(glm::distance(s.normalB, outwards) < 1e-3f);
    }
  }

  void seamsAreNoEnds() {
    const model::MeshPtr tube = test::cylinder(20.0f, 90.0f, 64, 20);
    const model::MeshPtr open = slit(*tube);
    QVERIFY(open != nullptr);
    QCOMPARE(rimsOf(open).size(), rimsOf(tube).size());
    QVERIFY(rimsOf(slit(*test::torus(50.0f, 20.0f, 60, 24))).empty());
  }

  /// They are among the contours.
  void contoursHoldThem() {
    const model::SurfacePtr surface = model::prepareSurface(test::cylinder(20.0f, 90.0f, 64, 20));
    model::Camera camera;
    camera.eye = {0.0f, -400.0f, 30.0f};
    camera.projection = model::Projection::perspective;
    const LineSet lines =
        extractLines(*surface, camera, {.kinds = {LineKind::contour}, .twoSided = true});
    const double around = 2.0 * std::numbers::pi * 20.0;
    const double length = lengthOf(lines[LineKind::contour]);
    QVERIFY2(std::abs(length - 2.0 * (around + 90.0)) < 8.0, qPrintable(QString::number(length)));
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::RimsTest)
#include "rims_test.moc"
