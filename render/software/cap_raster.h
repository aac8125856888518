// SPDX-License-Identifier: Apache-2.0
// Draws cut faces on the processor, as the cap pass does on a graphics card (METHOD §7).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/drawn/section_caps.h"
#include "render/software/surface_raster.h"

namespace sline::render {

/// A cut face and how it looks.
struct RasterCap {
  std::span<const glm::vec3> points;     ///< three of each triangle
  std::vector<glm::vec4> otherSections;  ///< (normal, −offset): they cut the face itself
  CapPaint paint;
};

/// Returns the cut faces of a structure that has some. `background` is the picture's.
std::vector<RasterCap> rasterCaps(const DrawnStructure& shown, const PictureView& view,
                                  Background background);

/// Tells whether no cut face reaches behind the eye, where a driver has to clip it.
bool areBeforeTheEye(std::span<const RasterCap> caps, const PictureView& view);
/// Draws them over what the samples of the area have, where they are nearer. Where there are no
/// colours only depths change.
void drawCaps(std::span<const RasterCap> caps, const PictureView& view, const SampleArea& samples,
              const RasterSurface& surface);

}  // namespace sline::render
