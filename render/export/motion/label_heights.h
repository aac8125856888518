// SPDX-License-Identifier: Apache-2.0
// Decides how high the labels of a film stand, for all frames together.
#pragma once

#include "render/export/motion/film.h"
#include "render/export/motion/film_label.h"

namespace sline::render {

/// Sets the height of each label in all frames, and the widths of columns. A label goes slowly
/// after its place, or stands still where this is near enough; in a column labels keep their order,
/// each with room of its own even where it is not in the picture, as far as there is room. A label
/// that changes sides is gone for a second. `labels` are those of the requests.
void planHeights(std::vector<FilmLabel>& labels, std::vector<LabelRequest>& frames,
                 const Film& film);

}  // namespace sline::render
