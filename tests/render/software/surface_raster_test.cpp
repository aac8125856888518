// SPDX-License-Identifier: Apache-2.0
// Compares depths with those of the nearest triangle, looked for one by one.
#include "render/software/surface_raster.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/drawn/prepared_surface.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

double turnOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// What one looks for at a sample: how deep the nearest front lies there, at the most and at the
/// least; the two differ where the sample is so near to an edge that a triangle may count or not.
struct Expected {
  double most = 1.0;
  double least = 1.0;
};

Expected expectedAt(const model::Mesh& mesh, const PictureView& view, const glm::dvec2& at) {
  Expected expected;
  for (const auto& triangle : mesh.triangles()) {
    std::array<glm::dvec2, 3> corner;
    std::array<double, 3> depth{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto seen = view.project(mesh.positions()[triangle[c]]);
      corner[c] = seen.pixel;
      depth[c] = double(seen.depth);
    }
    const double area = turnOf(corner[0], corner[1], corner[2]);
    if (area <= 1e-9)
      continue;
    std::array<double, 3> share{};
    double away = 1e9;  // px, from the edge that is nearest to keeping the sample out
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec2& from = corner[(c + 1) % 3];
      const glm::dvec2& to = corner[(c + 2) % 3];
      const double turn = turnOf(from, to, at);
      share[c] = turn / area;
      away = std::min(away, turn / std::max(glm::length(to - from), 1e-12));
    }
    if (away < -0.05)
      continue;
    const double there = std::clamp(share[0] * depth[0] + share[1] * depth[1] + share[2] * depth[2],
                                    std::min({depth[0], depth[1], depth[2]}),
                                    std::max({depth[0], depth[1], depth[2]}));
    expected.least = std::min(expected.least, there);
    if (away > 0.05)
      expected.most = std::min(expected.most, there);
  }
  return expected;
}

struct Ball {
  PreparedSurface prepared;
  DrawnStructure shown;
  explicit Ball(int subdivisions) {
    shown.mesh = test::sphere(40.0f, subdivisions);
    prepared.take(shown.mesh, {});
    shown.prepared = &prepared;
  }
};

std::optional<std::vector<float>> depthsOf(const DrawnStructure& shown, const PictureView& view,
                                           const TileMask& squares, const SampleArea& samples) {
  const RasterMember member{shown, {}, shown.surface().clusters};
  const PixelRect all{0, 0, samples.area.width, samples.area.height};
  std::vector<float> depths(std::size_t(all.width) * std::size_t(all.height), 1.0f);
  if (!rasterise({&member, 1}, {view, squares, samples, {&all, 1}}, {depths, {}}))
    return std::nullopt;
  return depths;
}

}  // namespace

class SurfaceRasterTest : public QObject {
  Q_OBJECT
 private slots:
  void areThoseOfTheNearestFront_data() {
    QTest::addColumn<int>("projection");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("subdivisions");
    QTest::newRow("fine, perspective") << int(model::Projection::perspective) << 60 << 1 << 5;
    QTest::newRow("fine, parallel") << int(model::Projection::orthographic) << 61 << 1 << 5;
    QTest::newRow("coarse") << int(model::Projection::perspective) << 400 << 1 << 1;
    QTest::newRow("every third pixel") << int(model::Projection::perspective) << 180 << 3 << 4;
  }

  void areThoseOfTheNearestFront() {
    QFETCH(int, projection);
    QFETCH(int, height);
    QFETCH(int, step);
    QFETCH(int, subdivisions);
    const Ball ball(subdivisions);
    const model::Camera camera{.projection = model::Projection(projection),
                               .eye = {70.0f, -200.0f, 40.0f}};
    const PictureView view(camera, ball.shown.mesh->bounds(), height, height);
    TileMask squares(view.whole());
    squares.markAll();
    const SampleArea samples{{{0, step / 2}, step}, {2, 1, height / step - 4, height / step - 3}};
    const auto depths = depthsOf(ball.shown, view, squares, samples);
    QVERIFY(depths && depths->size() == std::size_t(samples.area.width * samples.area.height));
    std::size_t covered = 0;
    std::size_t sure = 0;
    const int every = height > 100 && step == 1 ? 7 : 1;
    for (int row = 0; row < samples.area.height; row += every)
      for (int column = 0; column < samples.area.width; column += every) {
        const glm::dvec2 at =
            glm::dvec2(samples.grid.corner) +
            double(step) * (glm::dvec2(samples.area.x + column, samples.area.y + row) + 0.5);
        const Expected expected = expectedAt(*ball.shown.mesh, view, at);
        const double found =
            double((*depths)[std::size_t(row) * samples.area.width + std::size_t(column)]);
        sure += expected.most == expected.least;
        covered += found < 1.0;
        QVERIFY2(found > expected.least - 2e-5 && found < expected.most + 2e-5,
                 qPrintable(QString("%1, %2: %3 for %4 … %5")
                                .arg(column)
                                .arg(row)
                                .arg(found)
                                .arg(expected.least)
                                .arg(expected.most)));
      }
    QVERIFY(sure > 500 && covered > 200);
  }

  void keptValuesAreShadedAlike_data() {
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("byForm");
    QTest::addColumn<bool>("varies");
    using Kind = SurfaceFill::Kind;
    QTest::newRow("depths alone") << 1 << int(Kind::depthOnly) << false << false;
    QTest::newRow("flat") << 1 << int(Kind::flat) << false << false;
    QTest::newRow("shaded") << 1 << int(Kind::phong) << false << false;
    QTest::newRow("by form") << 1 << int(Kind::phong) << true << false;
    QTest::newRow("Γ varies") << 1 << int(Kind::phong) << true << true;
    QTest::newRow("coarse") << 3 << int(Kind::phong) << true << true;
  }

  /// What is found once serves fills that differ in all but what they need to know.
  void keptValuesAreShadedAlike() {
    QFETCH(int, step);
    QFETCH(int, kind);
    QFETCH(bool, byForm);
    QFETCH(bool, varies);
    const Ball ball(5);
    const PictureView view({.eye = {0.0f, -200.0f, 0.0f}}, ball.shown.mesh->bounds(), 300, 300);
    TileMask squares(view.whole());
    squares.markAll();
    const SampleArea samples{{{0, 0}, step}, {0, 0, 300 / step, 300 / step}};
    const PixelRect rect{10, 20, 260 / step, 190 / step};
    const RasterSight sight{view, squares, samples, {&rect, 1}, {0.6f, -0.8f, 0.0f}};
    SurfaceFill fill{.kind = SurfaceFill::Kind(kind),
                     .wash = {0.2f, 0.1f, 0.3f, 0.4f},
                     .colour = {0.9f, 0.4f, 0.1f},
                     .shading = 0.3f,
                     .byForm = byForm};
    if (varies) {
      GammaOffsets offsets(ball.shown.mesh->positions().size());
      for (std::size_t i = 0; i < offsets.size(); ++i)
        offsets[i] = float(i % 5) - 1.0f;
      fill.gammaOffsets = std::make_shared<const GammaOffsets>(std::move(offsets));
    }
    const auto count = std::size_t(samples.area.width) * std::size_t(samples.area.height);
    SurfaceValues found;
    QVERIFY(!found.serves(neededValues(fill)));
    QVERIFY(findValues({ball.shown, fill, ball.shown.surface().clusters}, sight, found));
    QVERIFY(found.serves(neededValues(fill)));
    for (const float shading : {0.3f, 0.8f}) {
      fill.shading = shading;
      fill.colour.g += 0.3f;
      std::vector<float> depths(count, 1.0f);
      std::vector<float> drawnDepths(count, 1.0f);
      std::vector<std::uint32_t> colours(count, 0);
      std::vector<std::uint32_t> drawnColours(count, 0);
      const RasterMember member{ball.shown, fill, ball.shown.surface().clusters};
      QVERIFY(rasterise({&member, 1}, sight, {drawnDepths, drawnColours}));
      shadeValues(fill, sight, found, {depths, colours});
      const auto inked =
          std::count_if(colours.begin(), colours.end(), [](auto c) { return c > 0; });
      QVERIFY(kind == int(SurfaceFill::Kind::depthOnly) || inked > 1000);
      for (int row = rect.y; row < rect.top(); ++row)
        for (int column = rect.x; column < rect.right(); ++column) {
          const std::size_t at = std::size_t(row * samples.area.width + column);
          QCOMPARE(depths[at], drawnDepths[at]);
          QCOMPARE(colours[at], drawnColours[at]);
        }
    }
  }

  /// A fill that sets in by the form needs what one that is complete does not.
  void valuesServeOnlyFillsThatNeedNoOthers() {
    const Ball ball(3);
    const PictureView view({.eye = {0.0f, -200.0f, 0.0f}}, ball.shown.mesh->bounds(), 100, 100);
    TileMask squares(view.whole());
    squares.markAll();
    SurfaceFill fill{.kind = SurfaceFill::Kind::flat};
    SurfaceValues found;
    QVERIFY(findValues({ball.shown, fill, ball.shown.surface().clusters},
                       {view, squares, {{}, view.whole()}, {}}, found));
    QVERIFY(found.serves(neededValues(fill)));
    fill.kind = SurfaceFill::Kind::phong;
    QVERIFY(!found.serves(neededValues(fill)));
    QVERIFY(findValues({ball.shown, fill, ball.shown.surface().clusters},
                       {view, squares, {{}, view.whole()}, {}}, found));
    QVERIFY(found.serves(neededValues(fill)));
    fill.byForm = true;
    QVERIFY(!found.serves(neededValues(fill)));
  }

  void clustersOutsideTheSquaresAreLeftOut() {
    const Ball ball(5);
    const PictureView view({.eye = {0.0f, -200.0f, 0.0f}}, ball.shown.mesh->bounds(), 320, 320);
    TileMask squares(view.whole());
    const SampleArea samples{{}, view.whole()};
    const auto count = [&] {
      const auto depths = depthsOf(ball.shown, view, squares, samples);
      return std::count_if(depths->begin(), depths->end(), [](float d) { return d < 1.0f; });
    };
    QCOMPARE(count(), 0);
    squares.mark({160, 160, 1, 1});
    const auto few = count();
    squares.markAll();
    QVERIFY(few > 0 && 4 * few < count());
  }

  void whatReachesBehindTheEyeIsLeftToADriver() {
    const Ball ball(3);
    const PictureView view(
        {.projection = model::Projection::perspective, .eye = {0.0f, -30.0f, 0.0f}},
        ball.shown.mesh->bounds(), 200, 200);
    TileMask squares(view.whole());
    squares.markAll();
    DrawnStructure shown = ball.shown;
    QVERIFY(!depthsOf(shown, view, squares, {{}, view.whole()}));
    // And what was found of it until then serves nobody.
    const SurfaceFill fill{.kind = SurfaceFill::Kind::phong};
    SurfaceValues found;
    QVERIFY(!findValues({shown, fill, shown.surface().clusters},
                        {view, squares, {{}, view.whole()}, {}}, found));
    QVERIFY(!found.serves(neededValues(fill)));
  }
};

SLINE_TEST(SurfaceRasterTest)
#include "surface_raster_test.moc"
