// SPDX-License-Identifier: Apache-2.0
// Defines what a layout is made of: boxes and polylines in the plane of the picture, in millimetres
// of the output from its upper left corner, y downwards.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace sline::render {

struct LabelBox {
  glm::vec2 low{0.0f};
  glm::vec2 high{0.0f};

  glm::vec2 size() const { return high - low; }
  glm::vec2 middle() const { return 0.5f * (low + high); }
  bool contains(const glm::vec2& p) const;
  LabelBox grown(float by) const { return {low - by, high + by}; }
  bool operator==(const LabelBox&) const = default;
};

/// The room that is kept free at each edge of the output.
struct EdgeRoom {
  float left = 0.0f;
  float top = 0.0f;
  float right = 0.0f;
  float bottom = 0.0f;
  bool operator==(const EdgeRoom&) const = default;
};

/// A polyline from the place in the anatomy to the box.
using Leader = std::vector<glm::vec2>;

/// Tells whether the insides of the boxes have points in common.
bool overlap(const LabelBox& a, const LabelBox& b);
/// Tells whether the leaders have a point in common; if both begin at the same place, another
/// point.
bool cross(const Leader& a, const Leader& b);
/// Tells whether a leader that begins elsewhere passes so near to the place that it touches or
/// seems to touch the dot there, and so to end on it. Dots that nearly touch each other cannot be
/// told apart by that.
bool passesDot(const Leader& leader, const glm::vec2& place);
/// Tells whether the leaders cross or one passes the other's dot.
bool disturb(const Leader& a, const Leader& b);
/// Tells whether the leader has a point within the box.
bool runsThrough(const Leader& leader, const LabelBox& box);
/// Returns where a straight leader from a place outside the box ends without running through it: in
/// the middle of the nearest of the sides that face the place, or so far from it that the leader is
/// not too flat above or below the text.
glm::vec2 portOf(const LabelBox& box, const glm::vec2& place);

}  // namespace sline::render
