// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/visibility.h"

#include <QtTest>
#include <cmath>

#include "model/geometry/spatial_order.h"
#include "render/lines/techniques/lines.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
model::Camera along(const glm::vec3& direction) {
  return {.projection = model::Projection::orthographic,
          .eye = 80.0f * glm::normalize(direction),
          .up = {0.1f, 0.05f, 1.0f}};
}

struct Seen {
  render::LineSet lines;
  std::vector<bool> visible;
  std::vector<bool> silhouette;
};

Seen see(const model::MeshPtr& mesh, const model::Camera& camera) {
  const auto surface = model::prepareSurface(mesh);
  const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
  Seen seen{render::extractLines(*surface, camera, {}), {}, {}};
  seen.visible =
      render::visibleSegments(*surface, bvh, camera, seen.lines[render::LineKind::contour]);
  seen.silhouette =
      render::silhouetteSegments(*surface, bvh, camera, seen.lines[render::LineKind::contour]);
  return seen;
}
}  // namespace

class VisibilityTest : public QObject {
  Q_OBJECT
 private slots:
  void allOfASphereIsSeen() {
    const Seen seen = see(test::sphere(5, 4), along({1, -2, 0.5f}));
    for (std::size_t i = 0; i < seen.lines[render::LineKind::contour].size(); ++i) {
      QVERIFY(seen.visible[i]);
      QVERIFY(seen.silhouette[i]);
    }
  }

  // Seen edge-on, a torus is one outline: the far and the near wall of its hole are hidden.
  void torusEdgeOnHidesItsHole() {
    const Seen seen = see(test::torus(10, 3, 200, 80), along({0, -1, 0.02f}));
    int hidden = 0;
    for (std::size_t i = 0; i < seen.lines[render::LineKind::contour].size(); ++i) {
      const glm::vec3 p = 0.5f * (seen.lines[render::LineKind::contour][i].a +
                                  seen.lines[render::LineKind::contour][i].b);
      const float ring = std::hypot(p.x, p.y);
      if (ring > 9.0f)
        continue;  // the outer side, or the top and bottom where both meet
      ++hidden;
      QVERIFY(!seen.visible[i]);
    }
    QVERIFY(hidden > 50);
  }

  // From above everything is in sight, and the hole's rim is silhouette too.
  void torusFromAboveShowsItsHole() {
    const Seen seen = see(test::torus(10, 3, 200, 80), along({0.01f, 0, 1}));
    for (std::size_t i = 0; i < seen.lines[render::LineKind::contour].size(); ++i) {
      QVERIFY(seen.visible[i]);
      QVERIFY(seen.silhouette[i]);
    }
  }

  // A contour in front of the body's own far side is visible but no silhouette.
  void innerContoursAreNoSilhouette() {
    const Seen seen = see(test::torus(10, 3, 200, 80), along({0, -1, 0.35f}));
    int inner = 0;
    for (std::size_t i = 0; i < seen.lines[render::LineKind::contour].size(); ++i)
      inner += seen.visible[i] && !seen.silhouette[i];
    QVERIFY(inner > 20);
    QVERIFY(std::size_t(inner) < seen.lines[render::LineKind::contour].size() / 2);
  }
};

SLINE_TEST(VisibilityTest)
#include "visibility_test.moc"
