// SPDX-License-Identifier: Apache-2.0
#include "render/software/cap_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/lines/patterns/cut_faces.h"
#include "render/sight/cut_away.h"
#include "render/sight/flat_triangle.h"

namespace sline::render {

namespace {

/// A triangle of a cut face in samples of the area.
class CapTriangle {
 public:
  CapTriangle(std::span<const glm::vec3> points, const PictureView& view, const SampleArea& samples)
      : CapTriangle(points,
                    {view.project(points[0]), view.project(points[1]), view.project(points[2])},
                    samples) {}

  const FlatTriangle& flat() const { return m_flat; }

  /// Returns the place in the patient.
  glm::vec3 placeAt(const glm::vec2& at) const {
    const glm::vec3 s = m_flat.inSpace(m_flat.sharesAt(at));
    return s.x * m_points[0] + s.y * m_points[1] + s.z * m_points[2];
  }

 private:
  CapTriangle(std::span<const glm::vec3> points, const std::array<PictureView::Point, 3>& seen,
              const SampleArea& samples)
      : m_points(points),
        m_flat(
            {inSamples(seen[0], samples), inSamples(seen[1], samples), inSamples(seen[2], samples)},
            1.0f / glm::vec3(seen[0].w, seen[1].w, seen[2].w)) {}
  static glm::vec2 inSamples(const PictureView::Point& seen, const SampleArea& samples) {
    return (seen.pixel - glm::vec2(samples.grid.corner)) / float(samples.grid.step) -
           glm::vec2(float(samples.area.x), float(samples.area.y));
  }

  std::span<const glm::vec3> m_points;
  FlatTriangle m_flat;
};

/// Draws cut faces, row by row.
class CapDrawer {
 public:
  CapDrawer(const RasterCap& cap, const PictureView& view, const SampleArea& samples,
            const RasterSurface& surface)
      : m_cap(cap), m_view(view), m_samples(samples), m_surface(surface) {}

  void draw(const CapTriangle& triangle, const PixelRect& cells) const {
    triangle.flat().forEachCell(cells, [&](int x, int y, const glm::vec3&) {
      const glm::vec2 at(float(x) + 0.5f, float(y) + 0.5f);
      const std::size_t i = std::size_t(y) * std::size_t(m_samples.area.width) + std::size_t(x);
      const float depth = depthAt(at);
      if (!(depth < m_surface.depths[i]) || isCutAway(m_cap.otherSections, triangle.placeAt(at)))
        return;
      m_surface.depths[i] = depth;
      if (!m_surface.colours.empty())
        m_surface.colours[i] = packedColour(colourAt(triangle, at));
    });
  }

 private:
  float depthAt(const glm::vec2& at) const {
    const glm::vec2 pixel = glm::vec2(m_samples.grid.corner) +
                            float(m_samples.grid.step) *
                                (at + glm::vec2(float(m_samples.area.x), float(m_samples.area.y)));
    return rule::faceDepth(m_cap.paint.depthPlane, pixel - 0.5f * m_view.size());
  }

  glm::vec4 colourAt(const CapTriangle& triangle, const glm::vec2& at) const {
    const CapPaint& paint = m_cap.paint;
    if (!(paint.strokeColour.a > 0.0f))
      return paint.colour;
    const auto stripeAt = [&](const glm::vec2& there) {
      return glm::dot(glm::vec3(paint.stripes), triangle.placeAt(there));
    };
    const float stripe = stripeAt(at);
    const glm::vec2 rise(stripeAt(at + glm::vec2(1.0f, 0.0f)) - stripe,
                         stripeAt(at + glm::vec2(0.0f, 1.0f)) - stripe);
    return glm::mix(
        paint.colour, paint.strokeColour,
        rule::stripeCoverage(stripe, glm::length(rise), paint.strokeHalfWidth, paint.stripes.w));
  }

  const RasterCap& m_cap;
  const PictureView& m_view;
  const SampleArea& m_samples;
  const RasterSurface& m_surface;
};

}  // namespace

std::vector<RasterCap> rasterCaps(const DrawnStructure& shown, const PictureView& view,
                                  Background background) {
  std::vector<RasterCap> caps;
  const SectionedSurface& cut = *shown.cut;
  for (std::size_t i = 0; i < cut.faces.size(); ++i)
    if (!cut.faces[i].cap.empty())
      caps.push_back({cut.faces[i].cap, sectionVectors(otherPlanes(*cut.surface, cut.planes, i)),
                      capPaint(shown, view, background, i)});
  return caps;
}

bool areBeforeTheEye(std::span<const RasterCap> caps, const PictureView& view) {
  return std::all_of(caps.begin(), caps.end(), [&](const RasterCap& cap) {
    return std::all_of(cap.points.begin(), cap.points.end(),
                       [&](const glm::vec3& point) { return view.project(point).w > 1e-6f; });
  });
}

void drawCaps(std::span<const RasterCap> caps, const PictureView& view, const SampleArea& samples,
              const RasterSurface& surface) {
  const PixelRect all{0, 0, samples.area.width, samples.area.height};
  for (const RasterCap& cap : caps) {
    const CapDrawer drawer(cap, view, samples, surface);
    for (std::size_t i = 0; i + 2 < cap.points.size(); i += 3) {
      const CapTriangle triangle(cap.points.subspan(i, 3), view, samples);
      const PixelRect box = triangle.flat().box(all);
      parallelFor(std::size_t(box.height), 16, [&](std::size_t row) {
        drawer.draw(triangle, {box.x, box.y + int(row), box.width, 1});
      });
    }
  }
}

}  // namespace sline::render
