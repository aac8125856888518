// SPDX-License-Identifier: Apache-2.0
// Names the patterns that tell tissues apart where they are cut, as printed atlases draw them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace sline::model {

enum class CutPattern {
  plain,       ///< no strokes
  spongy,      ///< irregular small rings within a dense rim: bone
  fibres,      ///< parallel short strokes: muscle, tendon
  cells,       ///< a network of small rounded cells: fat
  waterlines,  ///< broken level lines: fluid
  wall,        ///< strokes along the rim: vessels and hollow organs
  lamellae,    ///< strokes along the rim, all the way in: discs
  lacunae,     ///< sparse pairs of short marks: cartilage
  fascicles,   ///< round bundles with a dot within: nerves
  stipple,     ///< sparse fine dots, denser at the rim: parenchymal organs
  crossed,     ///< small crosses in disorder: lesions
  rim,         ///< strokes close to the rim, nothing within: skin
  blank        ///< no strokes, and no tint either: what lies within is not known
};

/// The names of the patterns in resources/anatomy/tissue_patterns.tsv, in the order of the values.
inline constexpr std::array<std::string_view, 13> cutPatternNames{
    "plain",   "spongy",    "fibres",  "cells",   "waterlines", "wall", "lamellae",
    "lacunae", "fascicles", "stipple", "crossed", "rim",        "blank"};

/// Tells whether the pattern stands along the rim and leaves open what is within: a lumen, or what
/// nobody has told apart.
inline bool isOpenWithin(CutPattern pattern) {
  return pattern == CutPattern::wall || pattern == CutPattern::rim || pattern == CutPattern::blank;
}

inline std::optional<CutPattern> cutPatternNamed(std::string_view name) {
  const auto* const found = std::find(cutPatternNames.begin(), cutPatternNames.end(), name);
  return found == cutPatternNames.end()
             ? std::nullopt
             : std::optional(CutPattern(found - cutPatternNames.begin()));
}

}  // namespace sline::model
