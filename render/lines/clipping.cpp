// SPDX-License-Identifier: Apache-2.0
#include "render/lines/clipping.h"

#include <algorithm>
#include <utility>

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
  }
  if (u < 1.0) {
    rest.b = at(s.a, s.b, u);
    rest.normalB = unitOr(at(s.normalA, s.normalB, u), s.normalB);
    rest.opacityB = at(s.opacityA, s.opacityB, u);
    rest.entryB = at(s.entryA, s.entryB, u);
  }
  return rest;
}

/// The farthest that any plane's removed side reaches over the point; ≤ 0 where it is kept.
double beyond(std::span<const model::Plane> planes, const glm::vec3& p) {
  double farthest = -1e30;
  for (const model::Plane& plane : planes)
    farthest = std::max(farthest, plane.distance(p));
  return farthest;
}

/// Where the way from a kept point to one that is not meets the first plane.
HatchPoint endBetween(const HatchPoint& kept, const HatchPoint& gone,
                      std::span<const model::Plane> planes) {
  double t = 1.0;
  for (const model::Plane& plane : planes) {
    const double from = plane.distance(kept.position);
    const double to = plane.distance(gone.position);
    if (to > 0.0)
      t = std::min(t, from / (from - to));
  }
  const auto mix = [share = float(t)](const auto& x, const auto& y) { return x + share * (y - x); };
  return {.position = mix(kept.position, gone.position),
          .normal = unitOr(mix(kept.normal, gone.normal), kept.normal),
          .halfWidth = mix(kept.halfWidth, gone.halfWidth)};
}

}  // namespace

std::optional<Segment> clipped(const Segment& segment, std::span<const model::Plane> planes) {
  double low = 0.0;
  double high = 1.0;
  for (const model::Plane& plane : planes) {
    const double a = plane.distance(segment.a);
    const double b = plane.distance(segment.b);
    if (a > 0.0 && b > 0.0)
      return std::nullopt;
    if (a > 0.0)
      low = std::max(low, a / (a - b));
    else if (b > 0.0)
      high = std::min(high, a / (a - b));
  }
  if (!(low < high))
    return std::nullopt;
  return part(segment, low, high);
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
  Hatching rest;
  for (const HatchStroke& stroke : hatching.strokes) {
    HatchStroke run = stroke;
    run.first = std::uint32_t(rest.points.size());
    const auto end = [&] {
      run.count = std::uint32_t(rest.points.size()) - run.first;
      if (run.count > 1 || (run.count == 1 && stroke.count == 1))
        rest.strokes.push_back(run);
      else
        rest.points.resize(run.first);
      run.first = std::uint32_t(rest.points.size());
    };
    bool keptBefore = false;
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
      const HatchPoint& p = hatching.points[stroke.first + i];
      const bool kept = !(beyond(planes, p.position) > 0.0);
      if (i > 0 && kept != keptBefore) {
        const HatchPoint& before = hatching.points[stroke.first + i - 1];
        rest.points.push_back(kept ? endBetween(p, before, planes) : endBetween(before, p, planes));
        if (!kept)
          end();
      }
      if (kept)
        rest.points.push_back(p);
      keptBefore = kept;
    }
    end();
  }
  hatching = std::move(rest);
}

}  // namespace sline::render
