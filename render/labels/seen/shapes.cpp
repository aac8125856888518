// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/shapes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sline::render {

namespace {

/// Returns twice the area of the triangle; its sign tells on which side of ab the point c is.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool within(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const double abc = turn(a, b, c);
  const double abd = turn(a, b, d);
  const double cda = turn(c, d, a);
  const double cdb = turn(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 &&
      cdb != 0)
    return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) ||
         (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
}

/// Returns the leader without its first bit.
Leader shortened(Leader leader) {
  constexpr float bit = 0.05f;
  const float length = glm::length(leader[1] - leader[0]);
  if (length > 2.0f * bit)
    leader[0] += bit / length * (leader[1] - leader[0]);
  return leader;
}

/// Returns the box around the whole leader.
LabelBox extentOf(const Leader& leader) {
  LabelBox box{leader.front(), leader.front()};
  for (const glm::vec2& p : leader) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

bool crossAnywhere(const Leader& a, const Leader& b) {
  const LabelBox one = extentOf(a);
  const LabelBox two = extentOf(b);
  if (one.high.x < two.low.x || two.high.x < one.low.x || one.high.y < two.low.y ||
      two.high.y < one.low.y)
    return false;
  for (std::size_t i = 1; i < a.size(); ++i)
    for (std::size_t j = 1; j < b.size(); ++j)
      if (meet(a[i - 1], a[i], b[j - 1], b[j]))
        return true;
  return false;
}

/// Tells whether the segment passes through the box, by Liang and Barsky's clipping.
bool clips(const glm::vec2& a, const glm::vec2& b, const LabelBox& box) {
  float enter = 0.0f;
  float leave = 1.0f;
  const glm::vec2 d = b - a;
  for (int i = 0; i < 2; ++i) {
    if (d[i] == 0.0f) {
      if (a[i] <= box.low[i] || a[i] >= box.high[i])
        return false;
      continue;
    }
    float first = (box.low[i] - a[i]) / d[i];
    float second = (box.high[i] - a[i]) / d[i];
    if (first > second)
      std::swap(first, second);
    enter = std::max(enter, first);
    leave = std::min(leave, second);
  }
  return enter < leave;
}

}  // namespace

bool LabelBox::contains(const glm::vec2& p) const {
  return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
}

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool cross(const Leader& a, const Leader& b) {
  constexpr float same = 0.01f;
  if (a.size() < 2 || b.size() < 2)
    return false;
  return glm::length(a[0] - b[0]) < same ? crossAnywhere(shortened(a), shortened(b))
                                         : crossAnywhere(a, b);
}

glm::vec2 portOf(const LabelBox& box, const glm::vec2& place) {
  const glm::vec2 middle = box.middle();
  const glm::vec2 beyond = glm::max(box.low - place, place - box.high);
  const glm::vec2 aside(place.x < middle.x ? box.low.x : box.high.x, middle.y);
  const float side = place.y < middle.y ? box.low.y : box.high.y;
  const float far = std::max(beyond.y, 0.0f);
  const glm::vec2 across(
      std::clamp(std::clamp(middle.x, place.x - far, place.x + far), box.low.x, box.high.x), side);
  if (beyond.x > 0.0f && beyond.y > 0.0f)
    return glm::length(aside - place) < glm::length(across - place) ? aside : across;
  return beyond.x > beyond.y ? aside : across;
}

bool passesDot(const Leader& leader, const glm::vec2& place) {
  constexpr float room = 0.62f;   // millimetres: more than the radius of a dot and half a pen
  constexpr float apart = 1.25f;  // between dots that one can tell apart
  if (leader.empty() || glm::distance(leader.front(), place) < apart)
    return false;
  for (std::size_t i = 1; i < leader.size(); ++i) {
    const glm::vec2 low = glm::min(leader[i - 1], leader[i]) - room;
    const glm::vec2 high = glm::max(leader[i - 1], leader[i]) + room;
    if (place.x < low.x || place.y < low.y || place.x > high.x || place.y > high.y)
      continue;
    const glm::vec2 way = leader[i] - leader[i - 1];
    const float squared = glm::dot(way, way);
    const float part = squared > 0.0f ? glm::dot(place - leader[i - 1], way) / squared : 0.0f;
    const glm::vec2 nearest = leader[i - 1] + std::clamp(part, 0.0f, 1.0f) * way;
    if (glm::distance(place, nearest) < room)
      return true;
  }
  return false;
}

bool disturb(const Leader& a, const Leader& b) {
  return cross(a, b) || (!b.empty() && passesDot(a, b.front())) ||
         (!a.empty() && passesDot(b, a.front()));
}

bool runsThrough(const Leader& leader, const LabelBox& box) {
  for (std::size_t i = 1; i < leader.size(); ++i)
    if (clips(leader[i - 1], leader[i], box))
      return true;
  return false;
}

}  // namespace sline::render
