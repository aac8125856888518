// SPDX-License-Identifier: Apache-2.0
// Shades a surface in a few flat tones that can be shapes of their own.
#pragma once

#include <span>
#include <vector>

#include "render/vectors/depth_layer.h"

namespace sline::render {

/// The limits of the number of steps from black to white, or from clear to opaque. The number grows
/// with a structure's size on the page, as few tones can be told apart on a small one.
inline constexpr int fewestToneSteps = 14;
inline constexpr int mostToneSteps = 64;

/// Fills `layer.tones` and `layer.colours` where `triangles` (one entry per pixel: index + 1, 0 for
/// none) says that the surface is seen.
void fillTones(const DrawnStructure& shown, const LayerInput& input,
               std::span<const std::uint32_t> triangles, DepthLayer& layer);

}  // namespace sline::render
