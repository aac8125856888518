// SPDX-License-Identifier: Apache-2.0
// Draws a curve with as few straight pieces as its course allows: every piece costs the ink pass
// the same, and where a surface has many triangles to a pixel most of them are shorter than that.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

namespace sline::render {

/// A point of a curve as the ink pass draws it.
struct JointPoint {
  glm::vec2 drawn{0.0f};  ///< the middle of the pen's stroke, px
  glm::vec2 line{0.0f};   ///< where it is looked up whether something hides the line, px
  float depth = 0.0f;     ///< of that place, mm from the eye's plane
  float width = 0.0f;     ///< px
  float opacity = 0.0f;
  float entry = 0.0f;  ///< see Segment
};

/// How far the points between a piece's ends may lie from what the piece says of their places.
struct JointLimits {
  float drawn = 0.0f;    ///< px, the stroke's middle and its width
  float line = 0.0f;     ///< px
  float depth = 0.0f;    ///< mm
  float longest = 0.0f;  ///< px, of a piece
};

/// Returns the last point to which one piece from the point `from` keeps the limits; the next point
/// where none does.
std::size_t farthestJoint(std::span<const JointPoint> points, std::size_t from,
                          const JointLimits& limits);

}  // namespace sline::render
