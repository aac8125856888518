// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_credits.h"

#include <algorithm>

#include "render/export/plate/source_credits.h"
#include "render/lettering/folded_text.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float creditLeading = 1.3f;   // ems
constexpr float creditIndentMm = 0.5f;  // as the legend's

float creditHeight(float points) {
  return creditLeading * points * millimetresPerPoint;
}

}  // namespace

std::string sourcesOf(const std::vector<ExportOrder>& panels) {
  std::vector<std::string> known;
  for (const ExportOrder& panel : panels)
    for (const SourceLine& line : sourceLines(panel.scene))
      if (std::find(known.begin(), known.end(), line.text) == known.end())
        known.push_back(line.text);
  std::string all;
  for (const std::string& line : known)
    all += (all.empty() ? "" : "; ") + line;
  return all;
}

float FigureCredits::heightIn(float widthMm) const {
  if (m_text.empty())
    return 0.0f;
  const auto lines =
      foldedText(QString::fromStdString(m_text), m_points, widthMm - 2.0f * creditIndentMm);
  return float(lines.size()) * creditHeight(m_points);
}

std::vector<LetteringItem> FigureCredits::drawnAt(const glm::vec2& corner, float widthMm) const {
  if (m_text.empty())
    return {};
  const auto lines =
      foldedText(QString::fromStdString(m_text), m_points, widthMm - 2.0f * creditIndentMm);
  LetteringText text{.at = corner + glm::vec2(creditIndentMm, capHeightMm(m_points)),
                     .leading = creditHeight(m_points),
                     .points = m_points,
                     .ink = letteringColours().ink};
  text.lines.assign(lines.begin(), lines.end());
  return {{.name = "sources", .shapes = {}, .text = std::move(text)}};
}

}  // namespace sline::render
