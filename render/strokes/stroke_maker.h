// SPDX-License-Identifier: Apache-2.0
// Makes strokes of a pen from segments and points of one surface in one view.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/drawn/section_caps.h"
#include "render/lines/ground/stage_entry.h"
#include "render/lines/ground/view_fields.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

struct Pen {
  float width;    ///< px
  float opacity;  ///< 0 … 1
};

/// Lines never become thinner than one pixel; they lose opacity instead (METHOD §4).
inline Pen devicePen(float width, float opacity) {
  return width >= 1.0f ? Pen{width, opacity} : Pen{1.0f, opacity * std::max(width, 0.0f)};
}

/// Returns the pixels over which the edge of hatching is softened. Its strokes are nearly all edge:
/// in print, at two pixels to λ and more, they would turn grey (METHOD §6.8); on the screen they
/// must not crawl.
inline float hatchEdge(float outputUnit) {
  return std::clamp(1.4f - 0.4f * outputUnit, 0.36f, 1.0f);
}

inline bool isContour(const Stroke& stroke) {
  return stroke.kind == StrokeKind::contour;
}

/// Collects strokes within an area of the picture.
class StrokeMaker {
 public:
  StrokeMaker(const model::Surface& surface, const PictureView& view, const PixelRect& area)
      : m_surface(surface), m_view(view), m_area(area), m_to(seen({}, {}, {})) {}

  /// Returns the strokes. Contours come last, as they are drawn in another way; each kind is sorted
  /// by depth, so that where strokes of a layer cross the nearest depth is written last; equal
  /// depths keep the surface's own order.
  std::vector<Stroke> take();

  /// Tells how far contours end a fill with tones, 0 … 1, which they must reach. Pens of pure line
  /// drawings stay even instead; as tones enter, these change without a jump.
  void setTones(float share) { m_tones = share; }

  /// Adds a contour, of which `inner` shares of width remain within the structure's own mask.
  void contour(const Segment& s, float width, float opacity, float inner) {
    Stroke stroke;
    if (!place(s, stroke))
      return;
    stroke.outwardA = outwardAt(m_from);
    stroke.outwardB = outwardAt(m_to);
    stroke.kind = StrokeKind::contour;
    stroke.innerShare = inner;
    stroke.tolerance = 0.5f * m_surface.meanEdge + 1e-3f * m_surface.filigreeSize;
    Pen penA = devicePen(s.pressureA * width, s.opacityA * opacity);
    Pen penB = devicePen(s.pressureB * width, s.opacityB * opacity);
    reachInwards(stroke.moveA, stroke.outwardA, penA);
    reachInwards(stroke.moveB, stroke.outwardB, penB);
    finish(stroke, penA, penB);
  }

  /// Adds the edge of a fill along a contour, one pixel wide, as opaque as said at a and b.
  void edge(const Segment& s, float opacityA, float opacityB) {
    Segment plain = s;
    plain.moveA = plain.moveB = glm::vec3(0.0f);
    plain.pressureA = plain.pressureB = 1.0f;
    plain.opacityA = opacityA;
    plain.opacityB = opacityB;
    contour(plain, 1.0f, 1.0f, 1.0f);
  }

  /// Adds a line around a cut face: centred on the line, in front of the faces that it borders.
  void outline(const Segment& s, float width, float opacity) {
    Stroke stroke;
    if (!place(s, stroke))
      return;
    stroke.depthA -= outlineLift;
    stroke.depthB -= outlineLift;
    stroke.tolerance = 0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
                       3.0f * m_view.millimetresPerPixel(s.a);
    finish(stroke, devicePen(width, s.opacityA * opacity), devicePen(width, s.opacityB * opacity));
  }

  /// How a pen draws one end of a line on the surface.
  struct LineEnd {
    Pen pen;  ///< of a line that has entered
    float t;  ///< T_SC
  };
  /// Adds a line on the surface.
  void surfaceLine(const Segment& s, const LineEnd& atA, const LineEnd& atB) {
    Stroke stroke;
    if (!place(s, stroke))
      return;
    stroke.tolerance =
        0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
        1.5f * m_view.millimetresPerPixel(s.a) * std::max(slopeAt(m_from), slopeAt(m_to));
    const auto pen = [](const LineEnd& end, float fade, float rank, float pressure) {
      const float share = entered(end.t, rank);
      const float full = end.pen.width * pressure * (0.45f + 0.55f * fade);
      return devicePen(full * std::min(1.0f, 0.35f + 0.65f * share),
                       end.pen.opacity * std::sqrt(fade) * std::min(1.0f, 2.0f * share));
    };
    finish(stroke, pen(atA, s.opacityA, s.entryA, s.pressureA),
           pen(atB, s.opacityB, s.entryB, s.pressureB));
  }

  /// Adds the marks on a cut face, at its depth.
  void pattern(const FacePattern& face, float width) {
    const glm::vec2 middle = 0.5f * m_view.size();
    const std::size_t first = m_strokes.size();
    for (const HatchStroke& s : face.marks->strokes) {
      const float pixel = m_view.millimetresPerPixel(s.seedPosition);
      const float near = pixel > 0.0f ? std::min(face.millimetresPerPixel / pixel, 1.0f) : 1.0f;
      hatching(std::span(face.marks->points).subspan(s.first, s.count), near * width * face.width,
               1.0f);
    }
    for (std::size_t i = first; i < m_strokes.size(); ++i) {
      Stroke& stroke = m_strokes[i];
      stroke.depthA = glm::dot(face.depthPlane, glm::vec3(stroke.a - middle, 1.0f));
      stroke.depthB = glm::dot(face.depthPlane, glm::vec3(stroke.b - middle, 1.0f));
    }
  }

  /// Adds a stroke of hatching as few capsules as its curve allows.
  void hatching(std::span<const HatchPoint> points, float width, float opacity);

 private:
  /// Widens a pen that draws beyond an outline as far as to the outline: in print, where λ is many
  /// pixels, a gap would open to the surface's fill. Thin pens stay thin.
  void reachInwards(glm::vec2& move, const glm::vec2& outward, Pen& pen) const {
    constexpr float betweenSamples = 0.25f;  // λ by which a line may lie outside between its points
    const float unit = m_view.outputUnit();
    const float printed = m_tones * std::clamp(unit - 1.0f, 0.0f, 1.0f);
    const float gap =
        std::min(printed * (glm::dot(move, outward) + betweenSamples * unit), 0.5f * pen.width);
    if (!(gap > 0.0f))
      return;
    move -= gap * outward;
    pen.width += gap;
  }

  // Limits within which points of hatching become one capsule: in λ, in pixels (for print) and in
  // points.
  static constexpr float chordError = 0.12f;
  static constexpr float chordErrorPx = 0.25f;
  static constexpr std::size_t longestChord = 8;

  Pen hatchPen(const HatchPoint& at, float width, float opacity) const {
    return devicePen(2.0f * at.halfWidth * m_view.outputUnit() * (width * at.ink),
                     opacity * at.ink);
  }

  float surfaceTolerance(const HatchPoint& a, const HatchPoint& b) const {
    return 0.1f * m_surface.meanEdge + 1e-4f * m_surface.featureSize +
           1.5f * m_view.millimetresPerPixel(a.position) *
               std::max(slope(a.position, a.normal), slope(b.position, b.normal));
  }

  /// Returns the last point to which one capsule from `from` stays true to the stroke's course and
  /// width.
  std::size_t farthestChord(std::span<const HatchPoint> points, std::size_t from) const;

  /// The end of a segment as it is seen. What is not needed of all is found when it is asked for.
  struct SeenEnd {
    glm::vec3 place{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 move{0.0f};
    PictureView::Point at{};
    glm::vec2 moved{0.0f};
    std::optional<glm::vec2> outward;
    std::optional<float> slope;
  };

  SeenEnd seen(const glm::vec3& at, const glm::vec3& normal, const glm::vec3& move) const {
    SeenEnd end{.place = at, .normal = normal, .move = move, .at = m_view.project(at)};
    if (move != glm::vec3(0.0f))
      end.moved = m_view.project(at + move).pixel - end.at.pixel;
    return end;
  }

  const glm::vec2& outwardAt(SeenEnd& end) const {
    if (!end.outward)
      end.outward = m_view.projectedDirection(end.place, end.normal);
    return *end.outward;
  }
  float slopeAt(SeenEnd& end) const {
    if (!end.slope)
      end.slope = slope(end.place, end.normal);
    return *end.slope;
  }

  /// Looks at a segment's ends; it mostly begins where the one before it ends.
  bool place(const Segment& s, Stroke& stroke) {
    if (s.a == m_to.place && s.normalA == m_to.normal && s.moveA == m_to.move)
      m_from = m_to;
    else
      m_from = seen(s.a, s.normalA, s.moveA);
    m_to = seen(s.b, s.normalB, s.moveB);
    stroke.moveA = m_from.moved;
    stroke.moveB = m_to.moved;
    return place(m_from.at, m_to.at, stroke);
  }

  static bool place(const PictureView::Point& a, const PictureView::Point& b, Stroke& stroke) {
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

  void finish(Stroke& stroke, const Pen& a, const Pen& b);

  const model::Surface& m_surface;
  const PictureView& m_view;
  PixelRect m_area;
  float m_tones = 0.0f;
  std::vector<Stroke> m_strokes;
  SeenEnd m_from;  ///< of the segment in work
  SeenEnd m_to;
  std::vector<PictureView::Point> m_seen;  ///< the points of the hatching stroke in work
};

}  // namespace sline::render
