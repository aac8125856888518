// SPDX-License-Identifier: Apache-2.0
#include "tests/render/labels/layout_promises.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace sline::render;

namespace sline::test {

std::vector<Line> linesOf(const Leader& leader) {
  std::vector<Line> lines;
  for (std::size_t i = 1; i < leader.size(); ++i)
    lines.push_back({leader[i - 1], leader[i]});
  return lines;
}

bool meet(const Line& one, const Line& two) {
  const glm::dvec2 r = one.b - one.a;
  const glm::dvec2 q = two.b - two.a;
  const glm::dvec2 w = two.a - one.a;
  const double determinant = r.x * q.y - r.y * q.x;
  if (std::abs(determinant) < 1e-12)
    return false;
  const double s = (w.x * q.y - w.y * q.x) / determinant;
  const double t = (w.x * r.y - w.y * r.x) / determinant;
  constexpr double rim = 1e-6;
  return s > rim && s < 1.0 - rim && t > rim && t < 1.0 - rim;
}

bool meets(const Line& line, const LabelBox& box) {
  for (int i = 0; i <= 400; ++i) {
    const glm::vec2 p(line.a + double(i) / 400.0 * (line.b - line.a));
    if (box.contains(p))
      return true;
  }
  return false;
}

QString inReserved(const LabelRequest& request, const LabelLayout& layout) {
  for (const PlacedLabel& label : layout.labels)
    for (const LabelBox& mark : request.space.reserved) {
      if (overlap(label.box, mark))
        return QString("%1 covers a mark").arg(label.id.value);
      for (const Line& line : linesOf(label.leader))
        if (label.post != LabelPost::byHand && meets(line, mark))
          return QString("the leader of %1 runs through a mark").arg(label.id.value);
    }
  return {};
}

QString broken(const LabelItem& item, const PlacedLabel& label) {
  constexpr float rounding = 0.01f;  // leaders end at the box's side
  for (const Line& line : linesOf(label.leader))
    if (meets(line, label.box.grown(-rounding)))
      return QString("%1 runs through itself").arg(label.id.value);
  if (label.post == LabelPost::byHand)
    return {};
  constexpr float dot = 0.8f;  // the largest dot, that of a pin
  for (const glm::vec2& place : item.places)
    if (glm::length(place - glm::clamp(place, label.box.low, label.box.high)) < dot)
      return QString("%1 covers its dot").arg(label.id.value);
  for (const Line& line : linesOf(item.places))
    if (meets(line, label.box))
      return QString("%1 covers what it measures").arg(label.id.value);
  return {};
}

QString passing(const LabelItem& item, const PlacedLabel& label) {
  constexpr double dot = 0.6;    // its radius, and the pen's
  constexpr double apart = 1.3;  // dots that one can tell apart
  for (const glm::vec2& place : item.places)
    for (const Line& line : linesOf(label.leader))
      for (int i = 0; i <= 400; ++i)
        if (glm::distance(glm::dvec2(place), line.a + double(i) / 400.0 * (line.b - line.a)) <
                dot &&
            glm::distance(place, label.leader.front()) > apart)
          return QString("the leader of %1 passes the dot of %2")
              .arg(label.id.value)
              .arg(item.id.value);
  return {};
}

QString broken(const LabelRequest& request, const LabelLayout& layout) {
  if (layout.labels.size() + layout.leftOut.size() != request.items.size())
    return "labels are lost";
  for (const LabelItem& item : request.items)
    if (const PlacedLabel* label = layout.find(item.id))
      if (const QString fault = broken(item, *label); !fault.isEmpty())
        return fault;
  const LabelSpace& space = request.space;
  for (const PlacedLabel& one : layout.labels) {
    if (one.box.low.x < -space.sideMargin || one.box.low.y < 0.0f ||
        one.box.high.x > space.size.x + space.sideMargin || one.box.high.y > space.size.y)
      return QString("%1 is outside").arg(one.id.value);
    for (const PlacedLabel& two : layout.labels) {
      if (one.id == two.id)
        continue;
      if (overlap(one.box, two.box))
        return QString("%1 and %2 overlap").arg(one.id.value).arg(two.id.value);
      for (const LabelItem& item : request.items)
        if (item.id == two.id)
          if (const QString fault = passing(item, one); !fault.isEmpty())
            return fault;
      for (const Line& line : linesOf(one.leader)) {
        if (meets(line, two.box))
          return QString("%1 runs through %2").arg(one.id.value).arg(two.id.value);
        for (const Line& other : linesOf(two.leader))
          if (meet(line, other))
            return QString("%1 and %2 cross").arg(one.id.value).arg(two.id.value);
      }
    }
  }
  return {};
}

LabelRequest roomy() {
  LabelRequest request;
  request.space.size = {340.0f, 190.0f};
  for (int i = 0; i < 8; ++i)
    request.items.push_back({.id = {std::uint64_t(i + 1)},
                             .places = {{130.0f + 11.0f * float(i), 40.0f + 13.0f * float(i)}},
                             .box = {30.0f, 4.5f}});
  request.obstacles = {.columns = 1,
                       .rows = 1,
                       .size = request.space.size,
                       .taken = {0},
                       .extent = LabelBox{{110.0f, 10.0f}, {230.0f, 180.0f}}};
  return request;
}

}  // namespace sline::test
