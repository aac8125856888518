// SPDX-License-Identifier: Apache-2.0
// Writes several drawings side by side as one SVG document.
#pragma once

#include <span>
#include <string>

#include "render/lettering/lettering.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// A drawing of lines and its place on the sheet.
struct SvgFigure {
  std::string id;    ///< of its group
  std::string name;  ///< its title
  const VectorDrawing* drawing = nullptr;
  glm::vec2 at{0.0f};  ///< upper left corner, mm
};

/// Returns a document of that size with a group for each drawing, and above them the lettering as
/// text. The page and its coordinates are in millimetres. Only lines are drawn; nothing may veil
/// them.
std::string svgSheet(const glm::vec2& sizeMm, std::span<const SvgFigure> figures,
                     const Lettering& lettering);

}  // namespace sline::render
