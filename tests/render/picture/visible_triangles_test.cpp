// SPDX-License-Identifier: Apache-2.0
// Compares the triangles that are drawn with those that cover the middle of a pixel.
#include "render/picture/surfaces/visible_triangles.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <set>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

using Corners = std::array<glm::dvec2, 3>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Tells whether the triangle, which turns its outside to the eye, holds the middle of a pixel.
/// Corners are in steps of the grid.
bool holdsMiddle(const Corners& c) {
  const glm::dvec2 low = glm::min(glm::min(c[0], c[1]), c[2]);
  const glm::dvec2 high = glm::max(glm::max(c[0], c[1]), c[2]);
  for (double y = std::floor(low.y) + 0.5; y <= high.y; y += 1.0)
    for (double x = std::floor(low.x) + 0.5; x <= high.x; x += 1.0) {
      const glm::dvec2 p(x, y);
      if (turn(c[0], c[1], p) > 0.0 && turn(c[1], c[2], p) > 0.0 && turn(c[2], c[0], p) > 0.0)
        return true;
    }
  return false;
}

}  // namespace

class VisibleTrianglesTest : public QObject {
  Q_OBJECT
 private slots:
  void holdAllThatCoverAPixel_data() {
    QTest::addColumn<int>("projection");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("step");
    QTest::newRow("fine, perspective") << int(model::Projection::perspective) << 60 << 1;
    QTest::newRow("fine, parallel") << int(model::Projection::orthographic) << 61 << 1;
    QTest::newRow("coarse") << int(model::Projection::perspective) << 2000 << 1;
    QTest::newRow("every third pixel") << int(model::Projection::perspective) << 180 << 3;
  }

  void holdAllThatCoverAPixel() {
    QFETCH(int, projection);
    QFETCH(int, height);
    QFETCH(int, step);
    PreparedSurface prepared;
    DrawnStructure shown;
    shown.mesh = test::sphere(40.0f, 5);
    prepared.take(shown.mesh, {});
    shown.prepared = &prepared;
    const model::Camera camera{.projection = model::Projection(projection),
                               .eye = {70.0f, -200.0f, 40.0f}};
    const PictureView view(camera, shown.mesh->bounds(), height, height);
    TileMask squares(view.whole());
    squares.markAll();
    const SampleGrid grid{{0, step / 2}, step};
    const std::vector<std::uint32_t> visible = visibleTriangles(shown, view, squares, grid);

    const model::Clusters& clusters = prepared.surface->clusters;
    std::set<std::array<std::uint32_t, 3>> found;
    for (std::size_t i = 0; i < visible.size(); i += 3)
      found.insert({clusters.vertices[visible[i]], clusters.vertices[visible[i + 1]],
                    clusters.vertices[visible[i + 2]]});
    std::size_t facing = 0;
    std::size_t needed = 0;
    for (const auto& triangle : shown.mesh->triangles()) {
      Corners corners;
      for (std::size_t c = 0; c < 3; ++c)
        corners[c] = (glm::dvec2(view.project(shown.mesh->positions()[triangle[c]]).pixel) -
                      glm::dvec2(grid.corner)) /
                     double(step);
      if (!(turn(corners[0], corners[1], corners[2]) > 1e-6))
        continue;
      ++facing;
      if (!holdsMiddle(corners))
        continue;
      ++needed;
      QVERIFY(found.contains({triangle[0], triangle[1], triangle[2]}));
    }
    QVERIFY(needed > 100);
    // Few more are drawn: those with the middle of a pixel close to an edge.
    QVERIFY2(double(found.size()) < 1.02 * double(facing), "triangles are drawn that face away");
    if (height / step <= 61)
      QVERIFY2(
          needed < facing / 2 && double(found.size()) < 1.5 * double(needed),
          qPrintable(QString("%1 of %2, %3 needed").arg(found.size()).arg(facing).arg(needed)));
  }

  void squaresThatAreNotAskedForStayOut() {
    PreparedSurface prepared;
    DrawnStructure shown;
    shown.mesh = test::sphere(40.0f, 5);
    prepared.take(shown.mesh, {});
    shown.prepared = &prepared;
    const PictureView view({.eye = {0.0f, -200.0f, 0.0f}}, shown.mesh->bounds(), 640, 640);
    TileMask squares(view.whole());
    QVERIFY(visibleTriangles(shown, view, squares).empty());
    squares.mark({320, 320, 1, 1});
    const std::size_t few = visibleTriangles(shown, view, squares).size();
    squares.markAll();
    QVERIFY(few > 0 && 4 * few < visibleTriangles(shown, view, squares).size());
  }
};

SLINE_TEST(VisibleTrianglesTest)
#include "visible_triangles_test.moc"
