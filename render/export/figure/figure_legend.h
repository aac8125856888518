// SPDX-License-Identifier: Apache-2.0
// Sets the one legend that all panels of a figure share.
#pragma once

#include <vector>

#include "render/export/order/export_order.h"
#include "render/export/plate/legend_row.h"

namespace sline::render {

/// Lists the structures of the panels, each name and colour once, in the order of the first panel
/// that has it.
class FigureLegendRows {
 public:
  FigureLegendRows(LegendList list, float points) : m_list(list), m_points(points) {}

  void add(const model::Scene& scene, const std::string& language);
  bool empty() const { return m_entries.empty(); }

  /// Returns the height that the legend needs in that width, millimetres; 0 where it is empty.
  float heightIn(float widthMm) const;
  /// Returns the rows, in columns from the left, with their upper left corner there.
  std::vector<LetteringItem> drawnAt(const glm::vec2& corner, float widthMm) const;

 private:
  struct Columns {
    std::size_t across = 1;
    std::size_t down = 0;
    float width = 0.0f;
  };
  Columns columnsIn(float widthMm) const;

  LegendList m_list;
  float m_points;
  std::vector<LegendEntry> m_entries;
};

}  // namespace sline::render
