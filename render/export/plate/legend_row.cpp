// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/legend_row.h"

namespace sline::render {

LetteringItem legendRow(const LegendEntry& entry, const glm::vec2& at, float points,
                        const LetteringColours& colours) {
  // Millimetres.
  constexpr float edge = 0.12f;
  constexpr float corner = 0.4f;
  constexpr float halo = 0.35f;
  const LegendMeasure measure(points);
  const glm::vec2 high{at.x + measure.swatch, at.y};
  LetteringItem row{.name = "legend: " + entry.name,
                    .shapes = {},
                    .text = LetteringText{.lines = {entry.text},
                                          .at = {at.x + measure.indent, at.y},
                                          .points = points,
                                          .ink = colours.ink}};
  row.shapes.push_back({.path = roundedBox(high - measure.swatch, high, corner),
                        .pen = edge,
                        .ink = colours.ink,
                        .fill = entry.colour,
                        .dashed = false,
                        .halo = halo});
  return row;
}

}  // namespace sline::render
