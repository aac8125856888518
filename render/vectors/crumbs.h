// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/vectors/visible_strokes.h"

namespace sline::render {

/// Returns the strokes without crumbs (METHOD §11.3): pieces shorter than 8 λ in all that continue
/// no other within 2 λ, as noise and the edges of what lies in front leave them. The longest piece
/// stays where nothing else of the line is left. `outputUnit` is λ in pixels.
std::vector<VisibleStroke> withoutCrumbs(std::vector<VisibleStroke> strokes, float outputUnit);

}  // namespace sline::render
