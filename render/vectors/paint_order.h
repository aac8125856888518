// SPDX-License-Identifier: Apache-2.0
// Decides in which order fills are painted. The picture finds it anew at every pixel, but shapes
// have one order for the whole page.
#pragma once

#include <span>
#include <vector>

#include "render/vectors/layer_stack.h"

namespace sline::render {

/// Returns the rank of each layer of the stack, 0 for the one painted first. Whatever shows through
/// a see-through fill is painted before that fill, on as much of the page as possible where fills
/// interlock. Otherwise the farthest comes first, by the depths given.
std::vector<std::size_t> paintRanks(const LayerStack& stack, std::span<const float> depths);

}  // namespace sline::render
