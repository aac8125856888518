// SPDX-License-Identifier: Apache-2.0
// Writes labels and marks to SVG as real text, so that it can be found, edited and translated.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "render/lettering/lettering.h"

namespace sline::render {

/// A layer of its own above the drawing.
struct SvgWriting {
  std::string id;    ///< "labels"
  std::string name;  ///< "Labels"
  Lettering lettering;
  bool halos = true;   ///< what is written stands on a drawing
  glm::vec2 at{0.0f};  ///< where its upper left corner lies on the page, mm
};

/// Appends the attribute that moves a group; nothing where it stays.
void appendMove(std::string& text, const glm::vec2& by);

/// Appends a mask of that id in which the halos of what is written over no ground are gaps, for the
/// group of the drawing; returns whether there are any, and appends nothing where there are none.
bool appendGaps(std::string& text, std::span<const SvgWriting> writings, const std::string& id,
                const glm::vec2& sizeMm, int decimals);

/// Appends the layer: a group of halos, which are paths, so that no reader paints them over
/// letters, and above them a group for each label or mark. An empty list adds nothing.
void appendLettering(std::string& text, const SvgWriting& writing, int decimals);

}  // namespace sline::render
