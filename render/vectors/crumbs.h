// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/vectors/visible_strokes.h"

namespace sline::render {

/// Returns the strokes as a pen draws them (METHOD §11.1, §11.3): those that continue each other
/// within 2 λ become one, and crumbs go, pieces shorter than `shortest` λ as noise and the edges of
/// what lies in front leave them. Rings stay, and what another stroke continues behind a veil, the
/// longest piece where nothing else of the line is left, and the larger pieces of a line that
/// others interrupt now and then, which would come and go together while the picture turns.
/// `outputUnit` is λ in pixels.
std::vector<VisibleStroke> withoutCrumbs(std::vector<VisibleStroke> strokes, float outputUnit,
                                         float shortest);

}  // namespace sline::render
