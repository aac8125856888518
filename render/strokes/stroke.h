// SPDX-License-Identifier: Apache-2.0
// Describes what a pen draws: a piece of a line in pixels of the whole picture, y upwards. The ink
// pass draws it, and vector drawings find which part of it can be seen.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace sline::render {

enum class StrokeKind : std::uint8_t {
  surfaceLine,  ///< centred on a line of the surface
  contour,      ///< outside a contour
  hatching      ///< like a surface line, its edge softer or harder
};

struct Stroke {
  glm::vec2 a{0.0f};
  glm::vec2 b{0.0f};
  float depthA = 0.0f;  ///< window depth, 0 … 1
  float depthB = 0.0f;
  float tolerance = 0.0f;  ///< mm by which its own surface may lie in front of it
  StrokeKind kind = StrokeKind::surfaceLine;
  float innerShare =
      1.0f;  ///< of a contour: the share of it that remains within the surface's own mask, 0 … 1
  float softness = 1.0f;  ///< of hatching: pixels over which its edge fades
  /// The moves from a and b to where the pen draws them, px; what hides a line is found at a and b.
  glm::vec2 moveA{0.0f};
  glm::vec2 moveB{0.0f};
  glm::vec2 outwardA{0.0f};
  glm::vec2 outwardB{0.0f};
  float halfWidthA = 1.0f;  ///< px, at least 0.5
  float halfWidthB = 1.0f;
  float opacityA = 1.0f;
  float opacityB = 1.0f;
  /// How far the round ends show beyond a and b at most, px: where the pen goes on, the next stroke
  /// covers the rest.
  float capA = whole;
  float capB = whole;
  static constexpr float whole = 1e6f;
};

}  // namespace sline::render
