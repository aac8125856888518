// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_legend.h"

#include <algorithm>

#include "render/export/plate/legend.h"

namespace sline::render {

namespace {

constexpr float indentMm = 0.5f;  // swatches have a halo

}  // namespace

void FigureLegendRows::add(const model::Scene& scene, const std::string& language) {
  for (const model::Node* node : legendStructures(scene, m_list)) {
    const LegendEntry entry{
        .name = node->name,
        .text = QString::fromStdString(structureName(*node, language)).simplified(),
        .colour = scene.resolve(node->id).colour};
    if (std::find(m_entries.begin(), m_entries.end(), entry) == m_entries.end())
      m_entries.push_back(entry);
  }
}

FigureLegendRows::Columns FigureLegendRows::columnsIn(float widthMm) const {
  const LegendMeasure measure(m_points);
  Columns columns;
  for (const LegendEntry& entry : m_entries)
    columns.width =
        std::max(columns.width, measure.indent + textWidthMm(TextLine(entry.text), m_points));
  columns.across = std::max<std::size_t>(
      1, std::size_t((widthMm - indentMm + measure.between) / (columns.width + measure.between)));
  columns.down = (m_entries.size() + columns.across - 1) / columns.across;
  return columns;
}

float FigureLegendRows::heightIn(float widthMm) const {
  return m_entries.empty() ? 0.0f : float(columnsIn(widthMm).down) * LegendMeasure(m_points).row;
}

std::vector<LetteringItem> FigureLegendRows::drawnAt(const glm::vec2& corner, float widthMm) const {
  const LegendMeasure measure(m_points);
  const Columns columns = columnsIn(widthMm);
  const float baseline = 0.8f;  // of a row's height
  std::vector<LetteringItem> rows;
  for (std::size_t i = 0; i < m_entries.size(); ++i) {
    const std::size_t columnIndex = i / columns.down;
    const auto column = float(columnIndex);
    const auto row = float(i % columns.down);
    rows.push_back(
        legendRow(m_entries[i],
                  corner + glm::vec2(indentMm + column * (columns.width + measure.between),
                                     (row + baseline) * measure.row),
                  m_points, letteringColours()));
  }
  return rows;
}

}  // namespace sline::render
