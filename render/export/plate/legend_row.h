// SPDX-License-Identifier: Apache-2.0
// Sets rows of legends: a swatch of a structure's colour and its name.
#pragma once

#include <QString>
#include <string>

#include "render/lettering/label_texts.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// The share of the labels' size that a legend's letters have, as other marks do.
inline constexpr float legendShare = 0.8f;

/// Lengths within a legend, for letters of that size; millimetres.
struct LegendMeasure {
  explicit LegendMeasure(float points)
      : row(1.5f * points * millimetresPerPoint),
        swatch(1.2f * capHeightMm(points)),
        indent(swatch + 0.45f * points * millimetresPerPoint),
        between(1.2f * points * millimetresPerPoint) {}
  float row;      ///< from one baseline to the next
  float swatch;   ///< a swatch's side
  float indent;   ///< from a swatch's left edge to its name
  float between;  ///< between columns
};

struct LegendEntry {
  std::string name;  ///< the structure's
  QString text;      ///< as the legend writes it
  Colour colour;
  bool operator==(const LegendEntry&) const = default;
};

/// Returns the row at that left end of its baseline.
LetteringItem legendRow(const LegendEntry& entry, const glm::vec2& at, float points,
                        const LetteringColours& colours);

}  // namespace sline::render
