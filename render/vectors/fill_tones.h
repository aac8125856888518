// SPDX-License-Identifier: Apache-2.0
// The shading of a surface in a few flat tones that can be shapes of their own.
#pragma once

#include <span>
#include <vector>

#include "render/vectors/depth_layer.h"

namespace sline::render {

/// Steps from black to white, or from clear to opaque: the finer the larger a structure is on the
/// page, as nobody sees many tones on a small one.
inline constexpr int fewestToneSteps = 14;
inline constexpr int mostToneSteps = 64;

/// Fills `layer.tones` and `layer.colours` where `triangles` (index + 1, 0 for none; one per pixel)
/// says that the surface is seen.
void fillTones(const DrawnStructure& shown, const LayerInput& input,
               std::span<const std::uint32_t> triangles, DepthLayer& layer);

}  // namespace sline::render
