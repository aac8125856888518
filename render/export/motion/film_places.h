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

}  // namespace sline::render
