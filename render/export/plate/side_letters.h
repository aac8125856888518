// SPDX-License-Identifier: Apache-2.0
// Places the letters of the body's sides at the edges of a picture.
#pragma once

#include <array>
#include <string>

#include "render/export/plate/free_places.h"
#include "render/labels/orientation_letters.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// A letter of an edge.
struct EdgeLetter {
  std::string letters;  ///< empty: the edge has none
  glm::vec2 at{0.0f};   ///< of its baseline, millimetres
  TextAnchor anchor = TextAnchor::start;
};
/// The letters of the ends of an axis.
using AxisLetters = std::array<EdgeLetter, 2>;

/// Returns the room of the letter: that of any letter, so that in a film one takes the place of
/// another.
LabelBox roomOf(const EdgeLetter& letter, float points);

/// Returns the letters of the left and the right edge on a page of that size, moved up or down
/// together where anatomy reaches the middle of the edges: the line between them shows how the body
/// stands. Where they have no room together they are in the middle.
AxisLetters lettersAcross(const EdgeLetters& letters, const glm::vec2& size, float points,
                          const FreePlaces& places);
/// Likewise those of the upper and the lower edge, moved sideways.
AxisLetters lettersUpright(const EdgeLetters& letters, const glm::vec2& size, float points,
                           const FreePlaces& places);

}  // namespace sline::render
