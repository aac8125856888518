// SPDX-License-Identifier: Apache-2.0
// Lists the techniques that styles choose, each with who published it and with what a person may
// set of it. The command line, its help, the panel and comparison sheets are made from this list;
// the thresholds come from the table of lines (line_technique.h).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/scene/style.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// A threshold of a technique, which several kinds of its lines may share.
struct TechniqueThreshold {
  std::string name;          ///< "ridges.curvature", as scene files and flags have it
  const char* id = "";       ///< "curvature"
  const char* meaning = "";  ///< in English, with its unit: F and F_c make lengths dimensionless
  float usual = 0.0f;
  Limits<float> limits;
  LineKinds kinds{};      ///< of the lines that it is about
  std::size_t which = 0;  ///< its place among the thresholds of each of these kinds
};

struct TechniqueFacts {
  model::Technique technique = model::Technique::sline;
  std::string_view id;       ///< "apparent_ridges", as scene files and flags have it
  const char* name = "";     ///< of its lines, in English
  const char* authors = "";  ///< who published them
  int year = 0;
  Gamma whole;  ///< the least Γ at which all of its lines have entered
  std::vector<TechniqueThreshold> thresholds;

  /// Tells whether it draws lines; noise is made of pixels.
  bool drawsLines() const { return !thresholds.empty(); }
  /// Returns "Judd et al. 2007".
  std::string citation() const;
};

/// Returns the techniques in the order of `model::Technique`.
std::span<const TechniqueFacts> techniqueList();
inline const TechniqueFacts& factsOf(model::Technique technique) {
  return techniqueList()[std::size_t(technique)];
}
/// Returns the kinds of lines that only this technique draws.
LineKinds kindsOf(model::Technique technique);

/// Returns the value of a threshold, held within its limits; the usual one where none is set.
float valueOf(const TechniqueThreshold& threshold, const model::ThresholdValues& values);
/// Returns the thresholds of all kinds with these values.
LineThresholds lineThresholds(const model::ThresholdValues& values);

/// Reads "laplacian=3", the first threshold of a technique, or "confis.margin=0.2". The error lists
/// what there is.
Result<model::ThresholdValue> parseThresholdValue(std::string_view text);
/// Returns a line for each threshold: its name, its meaning and its usual value.
std::string thresholdHelp();

}  // namespace sline::render
