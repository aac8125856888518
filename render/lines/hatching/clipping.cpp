// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/clipping.h"

namespace sline::render {

namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& other) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : other;
}

/// Moves end a to t and end b to u along the segment; an end at its own place stays untouched.
Segment part(const Segment& s, double t, double u) {
  const auto at = [](const auto& x, const auto& y, double where) {
    return x + float(where) * (y - x);
  };
  Segment rest = s;
  if (t > 0.0) {
    rest.a = at(s.a, s.b, t);
    rest.normalA = unitOr(at(s.normalA, s.normalB, t), s.normalA);
    rest.opacityA = at(s.opacityA, s.opacityB, t);
    rest.entryA = at(s.entryA, s.entryB, t);
    rest.gammaA = at(s.gammaA, s.gammaB, t);
  }
  if (u < 1.0) {
    rest.b = at(s.a, s.b, u);
    rest.normalB = unitOr(at(s.normalA, s.normalB, u), s.normalB);
    rest.opacityB = at(s.opacityA, s.opacityB, u);
    rest.entryB = at(s.entryA, s.entryB, u);
    rest.gammaB = at(s.gammaA, s.gammaB, u);
  }
  return rest;
}

/// Holds the part of the way from a to b that all planes keep, as shares of it.
struct Kept {
  double low = 0.0;
  double high = 1.0;
  bool any() const { return low < high; }
};

Kept kept(const glm::vec3& a, const glm::vec3& b, std::span<const model::Plane> planes) {
  Kept part;
  for (const model::Plane& plane : planes) {
    const double da = plane.distance(a);
    const double db = plane.distance(b);
    if (da > 0.0 && db > 0.0)
      return {1.0, 0.0};
    if (da > 0.0)
      part.low = std::max(part.low, da / (da - db));
    else if (db > 0.0)
      part.high = std::min(part.high, da / (da - db));
  }
  return part;
}

HatchPoint between(const HatchPoint& a, const HatchPoint& b, double t) {
  const auto at = [t](const auto& x, const auto& y) { return x + float(t) * (y - x); };
  return {.position = at(a.position, b.position),
          .normal = unitOr(at(a.normal, b.normal), a.normal),
          .halfWidth = at(a.halfWidth, b.halfWidth),
          .ink = at(a.ink, b.ink)};
}

/// Collects the parts of strokes.
class StrokeCutter {
 public:
  explicit StrokeCutter(std::span<const model::Plane> planes) : m_planes(planes) {}

  void cut(const HatchStroke& stroke, std::span<const HatchPoint> points) {
    begin(stroke);
    if (points.size() == 1 && model::keptByAll(m_planes, points.front().position))
      m_out.points.push_back(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Kept part = kept(points[i].position, points[i + 1].position, m_planes);
      if (!part.any()) {
        begin(stroke);
        continue;
      }
      if (part.low > 0.0)
        begin(stroke);
      if (m_out.points.size() == m_open.first)
        m_out.points.push_back(between(points[i], points[i + 1], part.low));
      m_out.points.push_back(part.high < 1.0 ? between(points[i], points[i + 1], part.high)
                                             : points[i + 1]);
      if (part.high < 1.0)
        begin(stroke);
    }
    begin(stroke);
  }

  Hatching take() { return std::move(m_out); }

 private:
  /// Ends the part under way and opens another.
  void begin(const HatchStroke& stroke) {
    m_open.count = std::uint32_t(m_out.points.size()) - m_open.first;
    if (m_open.count > 0)
      m_out.strokes.push_back(m_open);
    m_open = stroke;
    m_open.first = std::uint32_t(m_out.points.size());
    m_open.count = 0;
  }

  std::span<const model::Plane> m_planes;
  HatchStroke m_open;
  Hatching m_out;
};

}  // namespace

std::optional<Segment> clipped(const Segment& segment, std::span<const model::Plane> planes) {
  const Kept rest = kept(segment.a, segment.b, planes);
  return rest.any() ? std::optional<Segment>(part(segment, rest.low, rest.high)) : std::nullopt;
}

void clip(std::vector<Segment>& segments, std::span<const model::Plane> planes) {
  if (planes.empty())
    return;
  std::size_t kept = 0;
  for (const Segment& segment : segments)
    if (const std::optional<Segment> rest = clipped(segment, planes))
      segments[kept++] = *rest;
  segments.resize(kept);
}

void clip(Hatching& hatching, std::span<const model::Plane> planes) {
  if (planes.empty())
    return;
  StrokeCutter cutter(planes);
  for (const HatchStroke& stroke : hatching.strokes)
    cutter.cut(stroke, std::span(hatching.points).subspan(stroke.first, stroke.count));
  hatching = cutter.take();
}

}  // namespace sline::render
