// SPDX-License-Identifier: Apache-2.0
// Decides when labels of a film are there.
#pragma once

#include "render/export/motion/film.h"
#include "render/export/motion/film_label.h"

namespace sline::render {

/// Takes the label out where it would be there or gone for less than a second.
void stayForASecond(std::vector<bool>& there, const Film& film);

/// Takes labels out where they could not stand beside each other: as few as it finds necessary, and
/// rather such as are hidden. `labels` are those of the requests.
void keepApart(std::vector<FilmLabel>& labels, const std::vector<LabelRequest>& frames,
               const Film& film);

}  // namespace sline::render
