// SPDX-License-Identifier: Apache-2.0
// Tells where in a picture an answer is right: what is seen of a structure, as shapes that learning
// systems know.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/labels/seen/seen_map.h"

namespace sline::render {

/// Places are shares of the picture's width and height, 0 … 1 from its upper left corner.
struct QuestionZone {
  struct Box {
    glm::vec2 low{0.0f};
    glm::vec2 high{0.0f};
  };
  /// One polygon: its parts and the holes in them are joined by lines that lead there and back.
  std::vector<glm::vec2> outline;
  std::vector<Box> boxes;  ///< within it, the largest first; together they cover most of it
  float thickness = 0.0f;  ///< of its thickest place, as a share of the picture's height

  /// Tells whether a finger or a mouse hits it.
  bool canBeHit() const { return !outline.empty() && thickness >= 0.02f; }
};

/// Returns the zone of what is seen; specks of it are left out. `sizeMm` is the picture's size.
QuestionZone zoneOf(const SeenArea& area, const glm::vec2& sizeMm);

/// Tells whether the place is in the polygon, by the rule that counts crossings.
bool isWithin(const std::vector<glm::vec2>& outline, const glm::vec2& place);

}  // namespace sline::render
