// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/line_clip.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/lines/ground/cluster_walk.h"
#include "render/lines/ground/stage_entry.h"

namespace sline::render {

namespace {

void appendSide(const std::array<LineEnd, 2>& ends, float side, const LineClip& clip,
                std::uint32_t triangle, std::vector<Segment>& segments) {
  const float sign = clip.signedStrength ? side : 1.0f;
  std::array<float, 2> range{0.0f, 1.0f};
  keepWherePositive(side * ends[0].nv, side * ends[1].nv, range);
  keepWherePositive(sign * ends[0].strength - clip.least, sign * ends[1].strength - clip.least,
                    range);
  if (!(range[0] < range[1]))
    return;
  // Returns exactly y at t = 1, so that a line's segments share their ends to the last bit.
  const auto mix = [](const auto& x, const auto& y, float t) {
    return t >= 1.0f ? y : x + t * (y - x);
  };
  const float full = std::max(clip.least, 1e-6f);
  const auto strengthAt = [&](float t) {
    return sign * mix(ends[0].strength, ends[1].strength, t) / full;
  };
  const auto opacityAt = [&](float t) { return std::clamp(strengthAt(t) - 1.0f, 0.0f, 1.0f); };
  const auto entryAt = [&](float t) { return 1.0f / (1.0f + std::max(strengthAt(t), 0.0f)); };
  const auto normalAt = [&](float t) {
    const glm::vec3 n = mix(ends[0].normal, ends[1].normal, t);
    const float length = glm::length(n);
    return length > 0.0f ? side / length * n : n;
  };
  segments.push_back({.a = mix(ends[0].position, ends[1].position, range[0]),
                      .b = mix(ends[0].position, ends[1].position, range[1]),
                      .normalA = normalAt(range[0]),
                      .normalB = normalAt(range[1]),
                      .opacityA = opacityAt(range[0]),
                      .opacityB = opacityAt(range[1]),
                      .entryA = entryAt(range[0]),
                      .entryB = entryAt(range[1]),
                      .triangle = triangle});
}

}  // namespace

void keepWherePositive(float atA, float atB, std::array<float, 2>& range) {
  if (atA <= 0.0f && atB <= 0.0f)
    range = {0.0f, 0.0f};
  else if (atA <= 0.0f)
    range[0] = std::max(range[0], zeroBetween(atA, atB));
  else if (atB <= 0.0f)
    range[1] = std::min(range[1], zeroBetween(atA, atB));
}

void appendClipped(const std::array<LineEnd, 2>& ends, const LineClip& clip, std::uint32_t triangle,
                   std::vector<Segment>& segments) {
  appendSide(ends, 1.0f, clip, triangle, segments);
  if (clip.twoSided)
    appendSide(ends, -1.0f, clip, triangle, segments);
}

void rankByStrength(std::vector<Segment>& segments, const model::Surface&, const model::Camera&,
                    float) {
  replaceByRank(segments, [](const Segment&) { return true; });
}

}  // namespace sline::render
