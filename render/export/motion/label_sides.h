// SPDX-License-Identifier: Apache-2.0
// Decides on which side each label stands in a film as a whole.
#pragma once

#include <vector>

#include "render/export/motion/film.h"
#include "render/export/plate/figure_plate.h"

namespace sline::render {

/// Sets the side of each label in all frames: that on which its places are, with few changes. In a
/// film that loops it keeps one side, that of its place at the beginning unless this is near the
/// middle; in others it changes sides at most once in eight seconds. `most` is how many labels a
/// column has room for.
void keepSides(std::vector<LabelSights>& frames, const Film& film, std::size_t most);

}  // namespace sline::render
