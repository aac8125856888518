// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/depth_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "render/lines/ground/stages.h"
#include "render/sight/cut_away.h"
#include "render/sight/flat_triangle.h"
#include "render/strokes/hidden_lines.h"
#include "render/strokes/structure_lines.h"
#include "render/vectors/fill_tones.h"

namespace sline::render {

namespace {

constexpr float hairline = 0.75f;  // px, half of its width: just enough to leave no gaps

/// A triangle in the picture, with the window depths of its corners.
struct SeenTriangle {
  FlatTriangle flat;
  glm::vec3 depths;
};

/// Returns the triangle as it lies in the picture; nothing where it reaches behind the eye.
std::optional<SeenTriangle> projected(const PictureView& view, const std::array<glm::vec3, 3>& p) {
  const PictureView::Point a = view.project(p[0]);
  const PictureView::Point b = view.project(p[1]);
  const PictureView::Point c = view.project(p[2]);
  if (a.w <= 0.0f || b.w <= 0.0f || c.w <= 0.0f)
    return std::nullopt;
  return SeenTriangle{{{a.pixel, b.pixel, c.pixel}, 1.0f / glm::vec3(a.w, b.w, c.w)},
                      {a.depth, b.depth, c.depth}};
}

class LayerDrawing {
 public:
  LayerDrawing(const DrawnStructure& shown, const LayerInput& input, DepthLayer& layer)
      : m_shown(shown), m_input(input), m_layer(layer) {
    const std::size_t pixels = std::size_t(layer.area.width) * std::size_t(layer.area.height);
    layer.depths.assign(pixels, 1.0f);
    if (hasFill(shown.style) || hasCaps(shown))
      m_triangles.assign(pixels, 0);
  }

  void drawSurface() {
    const model::Surface& surface = m_shown.surface();
    const model::EyePoint& eye = m_input.view.eye();
    const bool cull = !needsTwoSides(surface, m_input.view.camera());
    std::vector<glm::vec4> planes;
    if (m_shown.cut)
      planes = sectionVectors(m_shown.cut->planes);
    for (const model::Cluster& cluster : surface.clusters.items) {
      if ((cull && model::facing(cluster, eye) == model::Facing::back) ||
          render::isCutAway(m_shown, cluster.bounds) ||
          intersection(grown(m_input.view.bounds(cluster.bounds), 1), m_layer.area).empty())
        continue;
      for (std::uint32_t i = 0; i < cluster.triangleCount; ++i)
        drawTriangle(surface.clusters.triangles[cluster.firstTriangle + i], cull, planes);
    }
  }

  void drawCaps() {
    if (!hasCaps(m_shown))
      return;
    m_caps.assign(m_layer.depths.size(), 0);
    for (std::size_t face = 0; face < m_shown.cut->faces.size(); ++face)
      if (!m_shown.cut->faces[face].cap.empty())
        drawCap(face);
  }

  /// Fills in the colours of everything that was drawn.
  void fill() {
    if (m_triangles.empty())
      return;
    m_layer.tones.assign(m_layer.depths.size(), 0);
    if (hasFill(m_shown.style))
      fillTones(m_shown, m_input, m_triangles, m_layer);
    m_layer.firstCapTone = m_layer.colours.size();
    if (m_caps.empty())
      return;
    for (std::size_t face = 0; face < m_shown.cut->faces.size(); ++face) {
      const CapPaint paint = capPaint(m_shown, m_input.view, m_input.background, face);
      m_layer.colours.push_back(paint.colour);
      m_layer.colours.push_back(paint.strokeColour);
    }
    for (std::size_t i = 0; i < m_caps.size(); ++i)
      if (m_caps[i] > 0)
        m_layer.tones[i] = std::uint8_t(m_layer.firstCapTone + m_caps[i]);
  }

 private:
  std::array<glm::vec3, 3> corners(std::uint32_t triangle) const {
    const auto positions = m_shown.surface().mesh->positions();
    const auto& [a, b, c] = m_shown.surface().mesh->triangles()[triangle];
    return {positions[a], positions[b], positions[c]};
  }

  void drawTriangle(std::uint32_t triangle, bool cull, std::span<const glm::vec4> planes) {
    const std::array<glm::vec3, 3> p = corners(triangle);
    if (cull) {
      const model::EyePoint& eye = m_input.view.eye();
      const glm::vec3 toEye = eye.atInfinity ? eye.value : eye.value - p[0];
      if (!(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), toEye) > 0.0f))
        return;
    }
    const std::optional<SeenTriangle> t = projected(m_input.view, p);
    if (!t)
      return;
    t->flat.forEachCell(m_layer.area, [&](int x, int y, const glm::vec3& shares) {
      const std::size_t i = std::size_t(m_layer.index(x, y));
      const float depth = glm::dot(shares, t->depths);
      if (!(depth >= 0.0f && depth < m_layer.depths[i]))
        return;
      if (!planes.empty()) {
        const glm::vec3 w = t->flat.inSpace(shares);
        if (isCutAway(planes, w.x * p[0] + w.y * p[1] + w.z * p[2]))
          return;
      }
      m_layer.depths[i] = depth;
      if (!m_triangles.empty())
        m_triangles[i] = triangle + 1;
    });
  }

  void drawCap(std::size_t face) {
    const CutFace& cut = m_shown.cut->faces[face];
    const CapPaint paint = capPaint(m_shown, m_input.view, m_input.background, face);
    const std::vector<glm::vec4> others =
        sectionVectors(otherPlanes(*m_shown.cut->surface, m_shown.cut->planes, face));
    const glm::vec2 middle = 0.5f * m_input.view.size();
    for (std::size_t k = 0; k + 2 < cut.cap.size(); k += 3) {
      const std::array<glm::vec3, 3> p{cut.cap[k], cut.cap[k + 1], cut.cap[k + 2]};
      const std::optional<SeenTriangle> t = projected(m_input.view, p);
      if (!t)
        continue;
      const auto place = [&](const glm::vec2& pixel) {
        const glm::vec3 w = t->flat.inSpace(t->flat.sharesAt(pixel));
        return w.x * p[0] + w.y * p[1] + w.z * p[2];
      };
      t->flat.forEachCell(m_layer.area, [&](int x, int y, const glm::vec3&) {
        const std::size_t i = std::size_t(m_layer.index(x, y));
        const glm::vec2 pixel(float(x) + 0.5f, float(y) + 0.5f);
        const float depth = rule::faceDepth(paint.depthPlane, pixel - middle);
        const glm::vec3 here = place(pixel);
        if (!(depth < m_layer.depths[i]) || isCutAway(others, here))
          return;
        m_layer.depths[i] = depth;
        m_triangles[i] = 0;
        const bool stroke = paint.strokeColour.a > 0.0f &&
                            onStripe(paint, here, place(pixel + glm::vec2(1.0f, 0.0f)) - here,
                                     place(pixel + glm::vec2(0.0f, 1.0f)) - here);
        m_caps[i] = std::uint8_t(1 + 2 * face + (stroke ? 1 : 0));
      });
    }
  }

  /// Tells whether a place lies on a stripe; `right` and `up` are a pixel's step.
  static bool onStripe(const CapPaint& paint, const glm::vec3& place, const glm::vec3& right,
                       const glm::vec3& up) {
    const glm::vec3 direction(paint.stripes);
    const float stripe = glm::dot(direction, place);
    const float perPixel =
        glm::length(glm::vec2(glm::dot(direction, right), glm::dot(direction, up)));
    // Strokes that have half entered are hairlines, as thinner ones would fall between pixels;
    // before that the picture has them paler than half of the ink.
    const bool entering = rule::stripeIsOdd(stripe) > 0.5f && paint.stripes.w > 0.45f;
    const float width =
        std::max(rule::stripeHalfWidth(stripe, paint.strokeHalfWidth, paint.stripes.w),
                 entering ? hairline : 0.0f);
    return rule::stripeAway(stripe, perPixel) < width;
  }

  const DrawnStructure& m_shown;
  const LayerInput& m_input;
  DepthLayer& m_layer;
  std::vector<std::uint32_t> m_triangles;  ///< one per pixel: index + 1; 0: none
  std::vector<std::uint8_t> m_caps;        ///< 0: none, else 1 + 2·face, one more on its strokes
};

}  // namespace

bool DepthLayer::variesInOpacity() const {
  float low = 1.0f;
  float high = 0.0f;
  for (std::size_t k = 0; k < firstCapTone; ++k) {
    low = std::min(low, colours[k].a);
    high = std::max(high, colours[k].a);
  }
  return high - low > 0.02f;
}

namespace {

/// Returns how far outside a structure its outline hides all: most of the pen's width, if it draws
/// in full.
float inkWidth(const DrawnStructure& shown, const LayerInput& input) {
  constexpr float sure = 0.7f;
  constexpr float whole = 0.99f;
  const float strength = transitions(shown.style.gamma).lines * shown.style.opacity.value();
  return strength < whole ? 0.0f
                          : sure * penWidth(shown.surface(), input.view, shown.style.penWeight);
}

}  // namespace

DepthLayer depthLayer(const DrawnStructure& shown, const LayerInput& input, const PixelRect& area) {
  DepthLayer layer;
  layer.area = area;
  LayerDrawing drawing(shown, input, layer);
  drawing.drawSurface();
  drawing.drawCaps();
  drawing.fill();
  layer.halo = haloWidth(shown.surface(), input.view, shown.style);
  layer.ink = inkWidth(shown, input);
  return layer;
}

float meanDepth(const DepthLayer& layer) {
  double sum = 0.0;
  std::size_t pixels = 0;
  for (const float depth : layer.depths)
    if (depth < 1.0f) {
      sum += double(depth);
      ++pixels;
    }
  return pixels > 0 ? float(sum / double(pixels)) : 1.0f;
}

}  // namespace sline::render
