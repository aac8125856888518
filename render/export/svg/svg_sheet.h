// SPDX-License-Identifier: Apache-2.0
// Writes several drawings side by side as one SVG document.
#pragma once

#include <span>
#include <string>

#include "model/scene/scene.h"
#include "render/export/order/export_order.h"
#include "render/export/svg/svg_lettering.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// A drawing and its place on the sheet; nothing of it shows outside of its own size.
struct SvgFigure {
  std::string id;    ///< of its group
  std::string name;  ///< its title
  const VectorDrawing* drawing = nullptr;
  glm::vec2 at{0.0f};  ///< upper left corner, mm
  /// The scene that names its structures; null for a drawing of lines alone that nothing veils.
  const model::Scene* scene = nullptr;
};

/// Returns a document of that size with a group for each drawing, each above those before, and
/// above them the writings as text. The page and its coordinates are in millimetres.
std::string svgSheet(const glm::vec2& sizeMm, std::span<const SvgFigure> figures,
                     std::span<const SvgWriting> writings, const ExportCredit& credit = {});

}  // namespace sline::render
