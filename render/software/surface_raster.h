// SPDX-License-Identifier: Apache-2.0
// Draws surfaces on the processor, as a graphics card would (METHOD §10): software drivers, which
// set triangles up one by one, take several times as long.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "render/drawn/drawn_structure.h"
#include "render/drawn/surface_fill.h"
#include "render/raster/pixel_rect.h"
#include "render/raster/tile_mask.h"
#include "render/software/layer_pixels.h"
#include "render/software/seen_cluster.h"
#include "render/software/surface_values.h"

namespace sline::render {

/// A surface to draw, and how; of one without a fill only the depth is found.
struct RasterMember {
  const DrawnStructure& shown;
  SurfaceFill fill;
  /// Those of the surface, or of a coarser form that has some of its vertices.
  const model::Clusters& clusters;
};

/// Says how surfaces are seen.
struct RasterSight {
  const PictureView& view;
  const TileMask& squares;  ///< clusters outside of these are left out
  SampleArea samples;
  /// What of the samples is drawn, from the area's corner on; no two overlap. Clusters beside the
  /// squares draw on others, too, which do not matter.
  std::span<const PixelRect> rectangles;
  glm::vec3 key{0.0f};  ///< unit, towards a key light in the patient's frame; 0: there is none
};

/// Names what is seen at each sample, in rows from the bottom.
struct RasterSurface {
  /// The window depth of the nearest triangle: what a driver's depth buffer would hold if it drew
  /// `visibleTriangles`. Has to be 1 before, or nearer where something hides the surfaces.
  std::span<float> depths;
  /// The fill there: red in the lowest 8 bits, premultiplied. May be empty where no member has one.
  std::span<std::uint32_t> colours;
};

/// Draws uncut surfaces; where two lie equally deep, the first is seen. Returns false, with part of
/// it drawn, where one reaches behind the eye or beyond the view's depths, and has to be clipped.
bool rasterise(std::span<const RasterMember> members, const RasterSight& sight,
               const RasterSurface& surface);

/// Finds what the shading of one surface needs, wherever the sight's squares are. Returns false,
/// with nothing found, where a cluster has to be clipped.
bool findValues(const RasterMember& member, const RasterSight& sight, SurfaceValues& found);
/// Shades within the sight's rectangles what `findValues` found in the same sight, which has to
/// serve the fill: depths and colours are then those that `rasterise` finds.
void shadeValues(const SurfaceFill& fill, const RasterSight& sight, const SurfaceValues& known,
                 const RasterSurface& surface);

}  // namespace sline::render
