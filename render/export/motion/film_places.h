// SPDX-License-Identifier: Apache-2.0
// Decides what the labels of a film point at, for all frames together.
#pragma once

#include <vector>

#include "render/export/motion/film.h"
#include "render/export/plate/figure_plate.h"

namespace sline::render {

/// Sets the place of each label of which the place is found: one sees there what it names, as long
/// as one sees it in any place, and it is kept, or followed by another at about the same height.
void choosePlaces(std::vector<LabelSights>& frames, const PlacePool& pool, const Film& film);

/// Sets the places anew now that the requests, whose items are those of the frames, know how high
/// labels stand: such places, as well seen and as steady, that fewer leaders meet.
void uncrossPlaces(std::vector<LabelRequest>& requests, const std::vector<LabelSights>& frames,
                   const PlacePool& pool, const Film& film);

/// Tells whether the leaders of two labels of one column meet however they are bent: their boxes
/// stand in the other order than their places, and the one from farther inside has its box where
/// the other's leader must pass.
bool leadersMeet(const LabelItem& a, const LabelItem& b);

}  // namespace sline::render
