// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/stroke_maker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/sight/rules.h"

namespace sline::render {

namespace {

constexpr std::uint32_t depthBits = 0x7fffffffu;

/// Tells, quickly, that a stroke lies within an area for sure.
bool liesWithin(const Stroke& s, const PixelRect& area) {
  const auto size = [](const glm::vec2& v) { return std::abs(v.x) + std::abs(v.y); };
  const float reach =
      2.0f * std::max(s.halfWidthA, s.halfWidthB) + 2.5f + std::max(size(s.moveA), size(s.moveB));
  const glm::vec2 low = glm::min(s.a, s.b) - reach;
  const glm::vec2 high = glm::max(s.a, s.b) + reach;
  return low.x > float(area.x) && low.y > float(area.y) && high.x < float(area.right()) &&
         high.y < float(area.top());
}

/// Returns the middle of the pen at an end.
glm::vec2 penAt(const Stroke& s, bool atB) {
  return atB ? s.b + s.moveB + rule::penOutside(s.halfWidthB) * s.outwardB
             : s.a + s.moveA + rule::penOutside(s.halfWidthA) * s.outwardA;
}

/// Tells whether a stroke begins as the one before it ends.
bool goesOn(const Stroke& before, const Stroke& s) {
  return before.b == s.a && before.kind == s.kind && before.moveB == s.moveA &&
         before.outwardB == s.outwardA && before.halfWidthB == s.halfWidthA &&
         before.opacityB == s.opacityA && before.innerShare == s.innerShare;
}

/// Returns how far two strokes must reach beyond their common end so that nothing of the bend
/// stays open.
float capAtBend(const Stroke& before, const Stroke& s) {
  constexpr float overlap = 0.25f;
  const float reach = std::max({before.halfWidthA, s.halfWidthA, s.halfWidthB}) + 0.5f;
  const glm::vec2 in = penAt(before, true) - penAt(before, false);
  const glm::vec2 out = penAt(s, true) - penAt(s, false);
  const float lengths = glm::length(in) * glm::length(out);
  if (!(lengths > 0.0f))
    return Stroke::whole;
  const float cosine = glm::dot(in, out) / lengths;
  return reach * std::sqrt(std::max(1.0f - cosine, 0.0f) / std::max(1.0f + cosine, 1e-3f)) +
         overlap;
}

}  // namespace

std::vector<Stroke> StrokeMaker::take() {
  // Numbers in the order of drawing: whether it is a contour, then the depth from far to near,
  // whose bits rise with it as it is not negative, then the stroke.
  std::vector<std::uint64_t> places;
  places.reserve(m_strokes.size());
  for (const Stroke& s : m_strokes) {
    const auto near =
        ~std::bit_cast<std::uint32_t>(std::max(s.depthA + s.depthB, 0.0f)) & depthBits;
    places.push_back(std::uint64_t(isContour(s)) << 63 | std::uint64_t(near) << 32 |
                     std::uint64_t(places.size()));
  }
  std::sort(places.begin(), places.end());
  std::vector<Stroke> sorted;
  sorted.reserve(places.size());
  for (const std::uint64_t place : places)
    sorted.push_back(m_strokes[std::uint32_t(place)]);
  m_strokes.clear();
  return sorted;
}

void StrokeMaker::hatching(std::span<const HatchPoint> points, float width, float opacity) {
  m_seen.clear();
  for (const HatchPoint& point : points)
    m_seen.push_back(m_view.project(point.position));
  const float softness = hatchEdge(m_view.outputUnit());
  const auto piece = [&](std::size_t from, std::size_t to) {
    const HatchPoint& a = points[from];
    const HatchPoint& b = points[to];
    Stroke stroke;
    if (!place(m_seen[from], m_seen[to], stroke))
      return;
    stroke.tolerance = surfaceTolerance(a, b);
    stroke.kind = StrokeKind::hatching;
    stroke.softness = softness;
    finish(stroke, hatchPen(a, width, opacity), hatchPen(b, width, opacity));
  };
  if (points.size() == 1)
    piece(0, 0);
  for (std::size_t from = 0, to = 0; from + 1 < points.size(); from = to) {
    to = farthestChord(points, from);
    piece(from, to);
  }
}

std::size_t StrokeMaker::farthestChord(std::span<const HatchPoint> points, std::size_t from) const {
  const float unit = m_view.outputUnit();
  const float most = std::min(chordError, chordErrorPx / unit);
  const glm::vec2 start = m_seen[from].pixel / unit;
  std::size_t to = from + 1;
  for (std::size_t end = from + 2; end < points.size() && end - from <= longestChord; ++end) {
    const glm::vec2 chord = m_seen[end].pixel / unit - start;
    const float length2 = std::max(glm::dot(chord, chord), 1e-12f);
    for (std::size_t i = from + 1; i < end; ++i) {
      const glm::vec2 d = m_seen[i].pixel / unit - start;
      const float t = std::clamp(glm::dot(d, chord) / length2, 0.0f, 1.0f);
      const float width = glm::mix(points[from].halfWidth, points[end].halfWidth, t);
      if (glm::length(d - t * chord) > most || std::abs(points[i].halfWidth - width) > most)
        return to;
    }
    to = end;
  }
  return to;
}

void StrokeMaker::finish(Stroke& stroke, const Pen& a, const Pen& b) {
  stroke.halfWidthA = 0.5f * a.width;
  stroke.halfWidthB = 0.5f * b.width;
  stroke.opacityA = a.opacity;
  stroke.opacityB = b.opacity;
  if (!(std::max(a.opacity, b.opacity) > 0.004f) ||
      (!liesWithin(stroke, m_area) && intersection(strokeBounds(stroke), m_area).empty()))
    return;
  if (!m_strokes.empty() && goesOn(m_strokes.back(), stroke))
    m_strokes.back().capB = stroke.capA = capAtBend(m_strokes.back(), stroke);
  m_strokes.push_back(stroke);
}

}  // namespace sline::render
