// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/structure_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/lines/chains.h"
#include "render/lines/clipping.h"
#include "render/lines/line_technique.h"
#include "render/lines/stage_entry.h"
#include "render/lines/stages.h"
#include "render/lines/view_fields.h"
#include "render/strokes/section_caps.h"

namespace sline::render {

namespace {

constexpr float standardPen = 2.0f;  // λ, METHOD §4

// The distance in λ within which a contour of a surface seen along its length may find its far
// side.
constexpr float wideStep = 2.5f;

// Where triangles are smaller than pixels, segments are joined: at most this many pixels off the
// line, to strokes of at most that many.
constexpr float simplification = 0.12f;
constexpr float longestStroke = 16.0f;
// Limits as above, but for hatching: in λ and in points.
constexpr float chordError = 0.12f;
constexpr std::size_t longestChord = 8;

struct Pen {
  float width;    ///< px
  float opacity;  ///< 0 … 1
};

/// Lines never become thinner than one pixel; they lose opacity instead (METHOD §4).
Pen devicePen(float width, float opacity) {
  return width >= 1.0f ? Pen{width, opacity} : Pen{1.0f, opacity * std::max(width, 0.0f)};
}

/// Returns the pixels over which the edge of hatching is softened. Its strokes are nearly all edge:
/// in print, at two pixels to λ and more, they would turn grey (METHOD §6.8); on the screen they
/// must not crawl.
float hatchEdge(float outputUnit) {
  return std::clamp(1.4f - 0.4f * outputUnit, 0.36f, 1.0f);
}

float pixelsPerMillimetre(const model::Surface& surface, const PictureView& view) {
  const float mm = view.millimetresPerPixel(surface.boundingSphere.centre);
  return mm > 0.0f ? 1.0f / mm : 0.0f;
}

/// Returns how far the triangles' own outline may lie from the line where nv = 0, in pixels: the
/// sagitta of an edge.
float outlineError(const model::Surface& surface, const PictureView& view) {
  const float sagitta =
      surface.meanEdge * surface.meanEdge / (2.0f * std::max(surface.filigreeSize, 1e-20f));
  return std::min(sagitta * pixelsPerMillimetre(surface, view), 2.0f);
}

bool isContour(const Stroke& stroke) {
  return stroke.kind == StrokeKind::contour;
}

class StrokeMaker {
 public:
  StrokeMaker(const model::Surface& surface, const PictureView& view, const PixelRect& area)
      : m_surface(surface), m_view(view), m_area(area) {}

  std::vector<Stroke> take() {
    // Contours come last, as they are drawn in another way; each kind is sorted by depth, so that
    // where strokes of a layer cross the nearest depth is written last; the sort is stable, so that
    // equal depths keep the surface's own order.
    std::stable_sort(m_strokes.begin(), m_strokes.end(), [](const auto& a, const auto& b) {
      if (isContour(a) != isContour(b))
        return isContour(b);
      return a.depthA + a.depthB > b.depthA + b.depthB;
    });
    return std::move(m_strokes);
  }

  /// Adds a contour. `t` is T_C, by which the parts within the structure's own mask enter.
  void contour(const Segment& s, float width, float opacity, float t) {
    Stroke stroke;
    if (!place(s.a, s.b, stroke))
      return;
    stroke.outwardA = m_view.projectedDirection(s.a, s.normalA);
    stroke.outwardB = m_view.projectedDirection(s.b, s.normalB);
    stroke.kind = StrokeKind::contour;
    stroke.innerShare = entered(t, 0.5f * (s.entryA + s.entryB));
    stroke.tolerance = 0.5f * m_surface.meanEdge + 1e-3f * m_surface.filigreeSize;
    finish(stroke, devicePen(width, s.opacityA * opacity), devicePen(width, s.opacityB * opacity));
  }

  /// Adds a line around a cut face: centred on the line, in front of the faces that it borders.
  void outline(const Segment& s, float width, float opacity) {
    Stroke stroke;
    if (!place(s.a, s.b, stroke))
      return;
    stroke.depthA -= outlineLift;
    stroke.depthB -= outlineLift;
    stroke.tolerance = 0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
                       3.0f * m_view.millimetresPerPixel(s.a);
    finish(stroke, devicePen(width, s.opacityA * opacity), devicePen(width, s.opacityB * opacity));
  }

  /// Adds a line on the surface; `t` is T_SC.
  void surfaceLine(const Segment& s, float width, float opacity, float t) {
    Stroke stroke;
    if (!place(s.a, s.b, stroke))
      return;
    stroke.tolerance = 0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
                       1.5f * m_view.millimetresPerPixel(s.a) *
                           std::max(slope(s.a, s.normalA), slope(s.b, s.normalB));
    const auto pen = [&](float fade, float rank) {
      const float share = entered(t, rank);
      const float full = width * (0.45f + 0.55f * fade);
      return devicePen(full * std::min(1.0f, 0.35f + 0.65f * share),
                       opacity * std::sqrt(fade) * std::min(1.0f, 2.0f * share));
    };
    finish(stroke, pen(s.opacityA, s.entryA), pen(s.opacityB, s.entryB));
  }

  /// Adds a stroke of hatching as few capsules as its curve allows.
  void hatching(std::span<const HatchPoint> points, float width, float opacity) {
    const float unit = m_view.outputUnit();
    for (std::size_t from = 0; from + 1 < points.size();) {
      const std::size_t to = farthestChord(points, from);
      Stroke stroke;
      const HatchPoint& a = points[from];
      const HatchPoint& b = points[to];
      if (place(a.position, b.position, stroke)) {
        stroke.tolerance = surfaceTolerance(a, b);
        stroke.kind = StrokeKind::hatching;
        stroke.softness = hatchEdge(unit);
        finish(stroke, devicePen(2.0f * a.halfWidth * unit * width, opacity),
               devicePen(2.0f * b.halfWidth * unit * width, opacity));
      }
      from = to;
    }
    if (points.size() == 1) {
      Stroke dot;
      const HatchPoint& at = points.front();
      if (place(at.position, at.position, dot)) {
        dot.tolerance = surfaceTolerance(at, at);
        dot.kind = StrokeKind::hatching;
        dot.softness = hatchEdge(unit);
        const Pen pen = devicePen(2.0f * at.halfWidth * unit * width, opacity);
        finish(dot, pen, pen);
      }
    }
  }

 private:
  float surfaceTolerance(const HatchPoint& a, const HatchPoint& b) const {
    return 0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
           1.5f * m_view.millimetresPerPixel(a.position) *
               std::max(slope(a.position, a.normal), slope(b.position, b.normal));
  }

  /// Returns the last point to which one capsule from `from` stays true to the stroke's course and
  /// width.
  std::size_t farthestChord(std::span<const HatchPoint> points, std::size_t from) const {
    const float unit = m_view.outputUnit();
    const glm::vec2 start = m_view.project(points[from].position).pixel / unit;
    std::size_t to = from + 1;
    for (std::size_t end = from + 2; end < points.size() && end - from <= longestChord; ++end) {
      const glm::vec2 chord = m_view.project(points[end].position).pixel / unit - start;
      const float length2 = std::max(glm::dot(chord, chord), 1e-12f);
      for (std::size_t i = from + 1; i < end; ++i) {
        const glm::vec2 d = m_view.project(points[i].position).pixel / unit - start;
        const float t = std::clamp(glm::dot(d, chord) / length2, 0.0f, 1.0f);
        const float width = glm::mix(points[from].halfWidth, points[end].halfWidth, t);
        if (glm::length(d - t * chord) > chordError ||
            std::abs(points[i].halfWidth - width) > chordError)
          return to;
      }
      to = end;
    }
    return to;
  }

  bool place(const glm::vec3& from, const glm::vec3& to, Stroke& stroke) const {
    const PictureView::Point a = m_view.project(from);
    const PictureView::Point b = m_view.project(to);
    if (a.w <= 0.0f || b.w <= 0.0f || a.depth < 0.0f || b.depth < 0.0f)
      return false;
    stroke.a = a.pixel;
    stroke.b = b.pixel;
    stroke.depthA = a.depth;
    stroke.depthB = b.depth;
    return true;
  }

  /// Returns how much depth changes per unit across the picture where the surface is seen at that
  /// angle.
  float slope(const glm::vec3& p, const glm::vec3& normal) const {
    const float nv = glm::dot(normal, directionTo(m_view.eye(), p));
    const float tangent = std::sqrt(std::max(0.0f, 1.0f - nv * nv)) / std::max(nv, 1e-3f);
    return std::min(tangent, 8.0f);
  }

  void finish(Stroke& stroke, const Pen& a, const Pen& b) {
    stroke.halfWidthA = 0.5f * a.width;
    stroke.halfWidthB = 0.5f * b.width;
    stroke.opacityA = a.opacity;
    stroke.opacityB = b.opacity;
    if (std::max(a.opacity, b.opacity) > 0.004f &&
        !intersection(strokeBounds(stroke), m_area).empty())
      m_strokes.push_back(stroke);
  }

  const model::Surface& m_surface;
  const PictureView& m_view;
  PixelRect m_area;
  std::vector<Stroke> m_strokes;
};

}  // namespace

bool showsLines(const model::ResolvedStyle& style) {
  return transitions(style.gamma).lines > 0.0f && style.penWeight > 0.0f;
}

bool showsHatching(const model::ResolvedStyle& style) {
  return showsLines(style) && transitions(style.gamma).hatching > 0.0f &&
         style.hatchDensity.value() > 0.0f && style.hatchTone.value() > 0.0f;
}

bool showsEdges(const model::ResolvedStyle& style) {
  return transitions(style.gamma).complete > 0.0f && style.opacity.value() > 0.0f;
}

float penWidth(const model::Surface& surface, const PictureView& view, float penWeight) {
  const float pen = standardPen * penWeight * view.outputUnit();
  const float across = 2.0f * surface.filigreeSize * pixelsPerMillimetre(surface, view);
  return pen * std::clamp(across / std::max(6.0f * pen, 1e-6f), 0.5f, 1.0f);
}

LineSet styledLines(const model::Surface& surface, const PictureView& view,
                    const model::ResolvedStyle& style) {
  LineRequest request{
      .kinds = {}, .thresholds = {}, .twoSided = needsTwoSides(surface, view.camera())};
  for (const LineTechnique& technique : lineTechniques())
    if (technique.bounds || (showsLines(style) && technique.entered(style.gamma) > 0.0f))
      request.kinds.add(technique.kind);
  return extractLines(surface, view.camera(), request);
}

Hatching styledHatching(StrokeLayout& layout, const PictureView& view,
                        const model::ResolvedStyle& style, const glm::vec3& light) {
  return extractHatching(layout, view.camera(),
                         {.entered = transitions(style.gamma).hatching,
                          .spacing = spacingOf(style.hatchDensity),
                          .tone = style.hatchTone.value(),
                          .light = light,
                          .aspect = view.size().x / view.size().y,
                          .twoSided = needsTwoSides(layout.surface(), view.camera())});
}

void cutLines(const SectionedSurface& cut, StructureLines& drawn) {
  for (const LineTechnique& technique : lineTechniques())
    clip(drawn.lines[technique.kind], cut.planes);
  clip(drawn.hatching, cut.planes);
  std::vector<Segment>& outlines = drawn.lines[LineKind::section];
  for (const CutFace& face : cut.faces)
    outlines.insert(outlines.end(), face.outline.begin(), face.outline.end());
}

void joinLines(const model::Surface& surface, const PictureView& view,
               const model::ResolvedStyle& style, LineSet& lines) {
  const float pixel = view.millimetresPerPixel(surface.boundingSphere.centre);
  const float unit = view.outputUnit() * pixel;
  const std::span<const LineTechnique> techniques = lineTechniques();
  parallelFor(techniques.size(), 1, [&](std::size_t i) {
    const LineTechnique& technique = techniques[i];
    std::vector<Segment>& segments = lines[technique.kind];
    if (technique.rank)
      technique.rank(segments, surface, view.camera(), technique.entered(style.gamma));
    if (!(pixel > 0.0f))
      return;
    const Chains chains = connectedChains(segments);
    const Specks& specks = technique.specks;
    if (specks.whole > 0.0f)
      fadeShortChains(segments, chains, specks.shortest * unit, specks.whole * unit);
    segments = simplified(segments, chains, simplification * pixel, longestStroke * pixel);
  });
}

ContourProbes contourProbes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style) {
  const float error = outlineError(surface, view);
  return {.probe = penWidth(surface, view, style.penWeight) + 1.0f + error,
          .reach = {1.0f + 0.5f * error, 2.0f + wideStep * view.outputUnit()},
          .sheet = 6.0f * surface.meanEdge +
                   wideStep * view.outputUnit() *
                       view.millimetresPerPixel(surface.boundingSphere.centre)};
}

std::vector<Stroke> strokes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style, const StructureLines& drawn,
                            const PixelRect& area) {
  StrokeMaker maker(surface, view, area);
  const Transitions t = transitions(style.gamma);
  const float pen = penWidth(surface, view, style.penWeight);
  const auto set = [&](const LineTechnique& technique) {
    const float entered = technique.entered(style.gamma);
    for (const Segment& s : drawn.lines[technique.kind])
      switch (technique.pen) {
        case LinePen::outside:
          maker.contour(s, pen * t.lines, t.lines, entered);
          break;
        case LinePen::centred:
          maker.surfaceLine(s, pen * t.lines, t.lines, entered);
          break;
        case LinePen::cutEdge:
          // Cut edges stay outlined where other lines leave: half as wide.
          maker.outline(s, pen * (0.5f + 0.5f * t.lines), style.penWeight > 0.0f ? 1.0f : 0.0f);
          break;
      }
  };
  for (const LineTechnique& technique : lineTechniques())
    if (technique.pen != LinePen::cutEdge)
      set(technique);
  for (const HatchStroke& s : drawn.hatching.strokes)
    maker.hatching(std::span(drawn.hatching.points).subspan(s.first, s.count), t.lines, t.lines);
  for (const LineTechnique& technique : lineTechniques())
    if (technique.pen == LinePen::cutEdge)
      set(technique);
  return maker.take();
}

std::vector<Stroke> edges(const model::Surface& surface, const PictureView& view,
                          const LineSet& lines, const PixelRect& area) {
  StrokeMaker maker(surface, view, area);
  for (const LineTechnique& technique : lineTechniques())
    if (technique.bounds)
      for (const Segment& s : lines[technique.kind])
        maker.contour(s, 1.0f, 1.0f, 1.0f);
  return maker.take();
}

std::size_t firstContour(std::span<const Stroke> strokes) {
  return std::size_t(std::find_if(strokes.begin(), strokes.end(), isContour) - strokes.begin());
}

PixelRect strokeBounds(const Stroke& s) {
  // The stroke's middle lies up to half a width off the line, its edge as much again, and half a
  // pixel of softness is added.
  const float reach = 2.0f * std::max(s.halfWidthA, s.halfWidthB) + 1.5f;
  const glm::vec2 limit(1e6f);
  const glm::vec2 low = glm::clamp(glm::floor(glm::min(s.a, s.b) - reach), -limit, limit);
  const glm::vec2 high = glm::clamp(glm::ceil(glm::max(s.a, s.b) + reach), -limit, limit);
  return {int(low.x), int(low.y), int(high.x - low.x), int(high.y - low.y)};
}

}  // namespace sline::render
