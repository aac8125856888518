// SPDX-License-Identifier: Apache-2.0
// Says whose work the surfaces of a figure's panels are, once for all of them, and what the figure
// shows.
#pragma once

#include <vector>

#include "render/export/order/export_order.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Returns whose work the visible surfaces of the panels are, each line once, as one text.
std::string sourcesOf(const std::vector<ExportOrder>& panels);

/// The text at a figure's foot, in as many lines as it needs.
class FigureCredits {
 public:
  FigureCredits() = default;
  FigureCredits(const std::string& text, float points) : m_text(text), m_points(points) {}

  /// Returns the height that it needs in that width, millimetres; 0 where nothing is said.
  float heightIn(float widthMm) const;
  /// Returns the text with its upper left corner there.
  std::vector<LetteringItem> drawnAt(const glm::vec2& corner, float widthMm) const;

 private:
  std::string m_text;
  float m_points = 0.0f;
};

}  // namespace sline::render
