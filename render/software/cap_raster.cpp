// SPDX-License-Identifier: Apache-2.0
#include "render/software/cap_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/lines/patterns/cut_faces.h"
#include "render/sight/rules.h"

namespace sline::render {

namespace {

/// A triangle of a cut face in samples of the area.
class CapTriangle {
 public:
  CapTriangle(std::span<const glm::vec3> points, const PictureView& view,
              const SampleArea& samples) {
    for (std::size_t c = 0; c < 3; ++c) {
      const PictureView::Point seen = view.project(points[c]);
      m_at[c] = (seen.pixel - glm::vec2(samples.grid.corner)) / float(samples.grid.step) -
                glm::vec2(float(samples.area.x), float(samples.area.y));
      m_perDepth[c] = 1.0f / seen.w;
      m_place[c] = points[c] * m_perDepth[c];
    }
    const glm::vec2 ab = m_at[1] - m_at[0];
    const glm::vec2 ac = m_at[2] - m_at[0];
    m_area = ab.x * ac.y - ab.y * ac.x;
  }

  bool flat() const { return !(std::abs(m_area) > 1e-6f); }

  /// Returns the samples that it may hold.
  PixelRect box(const PixelRect& within) const {
    const auto bounded = [](float x) { return int(std::clamp(x, -1e6f, 1e6f)); };
    const glm::vec2 low = glm::floor(glm::min(glm::min(m_at[0], m_at[1]), m_at[2]));
    const glm::vec2 high = glm::ceil(glm::max(glm::max(m_at[0], m_at[1]), m_at[2]));
    const int x = bounded(low.x);
    const int y = bounded(low.y);
    return intersection({x, y, bounded(high.x) - x + 1, bounded(high.y) - y + 1}, within);
  }

  /// Returns the corners' shares in the picture of a place; all above zero within.
  glm::vec3 sharesAt(const glm::vec2& at) const {
    const glm::vec2 ab = m_at[1] - m_at[0];
    const glm::vec2 ac = m_at[2] - m_at[0];
    const glm::vec2 way = at - m_at[0];
    const float toB = (way.x * ac.y - way.y * ac.x) / m_area;
    const float toC = (ab.x * way.y - ab.y * way.x) / m_area;
    return {1.0f - toB - toC, toB, toC};
  }

  /// Returns the place in the patient.
  glm::vec3 placeAt(const glm::vec2& at) const {
    const glm::vec3 s = sharesAt(at);
    return (s.x * m_place[0] + s.y * m_place[1] + s.z * m_place[2]) /
           (s.x * m_perDepth[0] + s.y * m_perDepth[1] + s.z * m_perDepth[2]);
  }

 private:
  std::array<glm::vec2, 3> m_at{};
  std::array<float, 3> m_perDepth{};
  std::array<glm::vec3, 3> m_place{};  ///< over the depth
  float m_area = 0.0f;                 ///< doubled
};

/// Draws cut faces, row by row.
class CapDrawer {
 public:
  CapDrawer(const RasterCap& cap, const PictureView& view, const SampleArea& samples,
            const RasterSurface& surface)
      : m_cap(cap), m_view(view), m_samples(samples), m_surface(surface) {}

  void draw(const CapTriangle& triangle, const PixelRect& box, int y) const {
    // By as much edges may lie beside those of a neighbour, so that no gap is left between.
    constexpr float slack = 1e-5f;
    for (int x = box.x; x < box.right(); ++x) {
      const glm::vec2 at(float(x) + 0.5f, float(y) + 0.5f);
      const glm::vec3 shares = triangle.sharesAt(at);
      if (std::min(shares.x, std::min(shares.y, shares.z)) < -slack)
        continue;
      const std::size_t i = std::size_t(y) * std::size_t(m_samples.area.width) + std::size_t(x);
      const float depth = depthAt(at);
      if (!(depth < m_surface.depths[i]) || isCut(triangle.placeAt(at)))
        continue;
      m_surface.depths[i] = depth;
      if (!m_surface.colours.empty())
        m_surface.colours[i] = packedColour(colourAt(triangle, at));
    }
  }

 private:
  float depthAt(const glm::vec2& at) const {
    const glm::vec2 pixel = glm::vec2(m_samples.grid.corner) +
                            float(m_samples.grid.step) *
                                (at + glm::vec2(float(m_samples.area.x), float(m_samples.area.y)));
    return std::clamp(
        glm::dot(m_cap.paint.depthPlane, glm::vec3(pixel - 0.5f * m_view.size(), 1.0f)), 0.0f,
        1.0f);
  }

  bool isCut(const glm::vec3& place) const {
    return std::any_of(
        m_cap.otherSections.begin(), m_cap.otherSections.end(),
        [&](const glm::vec4& plane) { return glm::dot(plane, glm::vec4(place, 1.0f)) > 0.0f; });
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
      const PixelRect box = triangle.box(all);
      if (triangle.flat() || box.empty())
        continue;
      parallelFor(std::size_t(box.height), 16,
                  [&](std::size_t row) { drawer.draw(triangle, box, box.y + int(row)); });
    }
  }
}

}  // namespace sline::render
