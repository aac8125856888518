// SPDX-License-Identifier: Apache-2.0
// In which order fills are painted. The picture finds it anew at every pixel; shapes have one for
// all of the page.
#pragma once

#include <span>
#include <vector>

#include "render/vectors/layer_stack.h"

namespace sline::render {

/// The rank of each layer of the stack, 0 for what is painted first: behind every see-through fill
/// is painted what shows through it, on as much of the page as can be where fills interlock. Else
/// the farthest comes first, by the depths given.
std::vector<std::size_t> paintRanks(const LayerStack& stack, std::span<const float> depths);

}  // namespace sline::render
