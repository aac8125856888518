// SPDX-License-Identifier: Apache-2.0
// Decides for how long a label of a film keeps its rank in its column.
#pragma once

#include <optional>
#include <vector>

#include "render/export/motion/film.h"
#include "render/export/motion/film_paths.h"

namespace sline::render {

/// Where a label's place is among those of its column, counted from the top, in a frame.
struct FrameRank {
  std::size_t rank = 0;
  double weight = 1.0;  ///< how much it matters that the label is there
};

/// Returns the frames of each stretch in which the label keeps one rank: with few changes, as each
/// costs a second of its absence, and where few others would stand in its way. Half a second is
/// missing at either end of a stretch where another begins.
std::vector<Presence> rankStretches(const std::vector<std::optional<FrameRank>>& ranks,
                                    const Film& film);

}  // namespace sline::render
