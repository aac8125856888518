// SPDX-License-Identifier: Apache-2.0
#include "render/labels/label_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {
constexpr float airToDrawn = 0.4f;  // around a box: as text keeps off others
}

bool standsBeside(const LabelItem& item) {
  return item.kind == model::AnnotationKind::pin || item.kind == model::AnnotationKind::distance;
}

bool isColumn(LabelPost post) {
  return post == LabelPost::left || post == LabelPost::right;
}

LabelPost otherSide(LabelPost post) {
  return post == LabelPost::left ? LabelPost::right : LabelPost::left;
}

bool jumps(const PlacedLabel& was, const PlacedLabel& is) {
  constexpr float jump = 2.0f;
  return was.post != is.post || std::abs(was.box.middle().y - is.box.middle().y) > jump;
}

bool coversOwn(const LabelItem& item, const LabelBox& box) {
  constexpr float rounding = 1e-2f;
  const LabelBox room = box.grown(dotRoom - rounding);
  return runsThrough(item.places, box.grown(clearance)) ||
         std::any_of(item.places.begin(), item.places.end(),
                     [&](const glm::vec2& place) { return room.contains(place); });
}

glm::vec2 placeOf(const LabelItem& item) {
  glm::vec2 sum(0.0f);
  for (const glm::vec2& place : item.places)
    sum += place;
  return sum / float(std::max<std::size_t>(item.places.size(), 1));
}

float middleBetweenColumns(const std::vector<LabelItem>& items, const LabelBox& anatomy) {
  constexpr float nearMiddle = 0.02f;  // of the anatomy's width, to either side
  const float middle = anatomy.middle().x;
  if (items.empty())
    return middle;
  std::vector<float> xs;
  xs.reserve(items.size());
  for (const LabelItem& one : items)
    xs.push_back(placeOf(one).x);
  std::sort(xs.begin(), xs.end());
  const float half = 0.5f * (xs[(xs.size() - 1) / 2] + xs[xs.size() / 2]);
  const float most = nearMiddle * anatomy.size().x;
  return std::clamp(half, middle - most, middle + most);
}

LabelBox frameOf(const LabelSpace& space) {
  const auto room = [](float edge) { return std::max(edge, edgePadding); };
  return {{room(space.edges.left) - space.sideMargin, room(space.edges.top)},
          {space.size.x - room(space.edges.right) + space.sideMargin,
           space.size.y - room(space.edges.bottom)}};
}

std::array<float, 2> edgesBeside(const LabelBox& anatomy) {
  return {anatomy.low.x - anatomyGap, anatomy.high.x + anatomyGap};
}

std::array<float, 2> edgesOf(const std::array<float, 2>& beside, const LabelBox& frame,
                             const std::array<float, 2>& widths) {
  return {std::max(beside[0], frame.low.x + widths[0]),
          std::min(beside[1], frame.high.x - widths[1])};
}

bool hasRoom(const LabelBox& frame, const glm::vec2& box) {
  return box.x <= frame.size().x && box.y <= frame.size().y;
}

bool within(const LabelBox& box, const LabelBox& frame) {
  constexpr float rounding = 1e-3f;
  const LabelBox room = frame.grown(rounding);
  return box.low.x >= room.low.x && box.low.y >= room.low.y && box.high.x <= room.high.x &&
         box.high.y <= room.high.y;
}

bool liesOver(const SeenArea& drawn, const LabelBox& box) {
  return drawn.anyIn(box.grown(airToDrawn));
}

std::vector<Span> heightsOver(const SeenArea& drawn, const Span& across) {
  std::vector<Span> heights;
  const SeenGrid& grid = drawn.grid;
  for (int y = 0; y < grid.rows; ++y) {
    const float middle = grid.middle(0, y).y;
    if (!drawn.anyIn({{across.low - airToDrawn, middle}, {across.high + airToDrawn, middle}}))
      continue;
    constexpr float rounding = 1e-2f;
    const float reach = 0.5f * grid.side + airToDrawn + rounding;
    if (heights.empty() || heights.back().high < middle - reach)
      heights.push_back({middle - reach, middle + reach});
    heights.back().high = middle + reach;
  }
  return heights;
}

bool overlapAny(const LabelBox& box, const std::vector<LabelBox>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const LabelBox& other) { return overlap(box, other); });
}

LabelBox besideReserved(const LabelBox& box, const LabelBox& frame,
                        const std::vector<LabelBox>& reserved) {
  const auto free = [&](const LabelBox& moved) { return !overlapAny(moved, reserved); };
  if (free(box))
    return box;
  std::optional<LabelBox> best;
  float least = 0.0f;
  for (const LabelBox& one : reserved) {
    const std::array<glm::vec2, 4> ways{{{one.low.x - clearance - box.high.x, 0.0f},
                                         {one.high.x + clearance - box.low.x, 0.0f},
                                         {0.0f, one.low.y - clearance - box.high.y},
                                         {0.0f, one.high.y + clearance - box.low.y}}};
    for (const glm::vec2& way : ways) {
      const LabelBox moved{box.low + way, box.high + way};
      const float far = glm::length(way);
      if ((!best || far < least) && within(moved, frame) && free(moved)) {
        best = moved;
        least = far;
      }
    }
  }
  return best.value_or(box);
}

std::optional<Span> heightsWithin(const Leader& leader, float low, float high) {
  std::optional<Span> heights;
  for (std::size_t k = 1; k < leader.size(); ++k) {
    glm::vec2 a = leader[k - 1];
    glm::vec2 b = leader[k];
    if (a.x > b.x)
      std::swap(a, b);
    if (b.x < low || a.x > high)
      continue;
    const float length = b.x - a.x;
    for (const float x : {std::max(a.x, low), std::min(b.x, high)}) {
      const float y = length > 0.0f ? a.y + (x - a.x) / length * (b.y - a.y) : a.y;
      const float other = length > 0.0f ? y : b.y;
      heights = heights
                    ? Span{std::min({heights->low, y, other}), std::max({heights->high, y, other})}
                    : Span{std::min(y, other), std::max(y, other)};
    }
  }
  return heights;
}

Leader leaderTo(const LabelBox& box, const glm::vec2& place) {
  if (box.grown(clearance).contains(place))
    return {};
  return {place, portOf(box, place)};
}

}  // namespace sline::render
