// SPDX-License-Identifier: Apache-2.0
// Describes a structure as a layer of the picture, or all opaque structures together as one (METHOD
// §10).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/scene/scene.h"
#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_settings.h"
#include "render/gpu/device.h"
#include "render/picture/layer_caps.h"
#include "render/picture/surfaces/surface_cache.h"
#include "render/picture/surfaces/tile_lists.h"
#include "render/software/layer_pixels.h"
#include "render/software/occlusion.h"
#include "render/software/surface_values.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

/// A structure to draw, with what the GPU holds of it.
struct PreparedStructure : DrawnStructure {
  CachedSurface* cached = nullptr;  ///< the same as `prepared`, with the GPU's part
  /// A coarser form of the surface, of which samples are taken where each stands for several
  /// pixels; null: of the surface itself. Belongs to `cached`.
  const model::Clusters* sampled = nullptr;
  bool printedHatching = false;           ///< hatched pixel by pixel
  bool buried = false;                    ///< others of its like hide it: see Coinciding
  std::shared_ptr<CappedSurface> capped;  ///< the same as `cut`, with the GPU's part

  /// Tells whether both have one surface, cut alike, whose style and hatching may differ.
  bool sharesSurface(const PreparedStructure& other) const {
    return id == other.id && mesh == other.mesh && cached == other.cached &&
           gammaOffsets == other.gammaOffsets && alike(sections, other.sections);
  }
  bool operator==(const PreparedStructure& other) const {
    return sharesSurface(other) && style == other.style &&
           printedHatching == other.printedHatching && pattern == other.pattern &&
           hatchCells == other.hatchCells;
  }
};

struct Layer {
  std::vector<PreparedStructure>
      members;  ///< one structure, or by id all that are opaque and without lines
  /// Of each member: see `findTriangles`; of none where all are drawn.
  std::vector<std::vector<std::uint32_t>> triangles;
  /// What is seen of its only member's surface, kept where few layers change: to be found while it
  /// has no depths.
  std::optional<SurfaceValues> values;
  std::uint64_t drawing = 0;  ///< tells what was drawn of it from all other layers
  LayerPixels pixels;         ///< what of it the processor drew instead: see `drawOnProcessor`
  bool onProcessor = false;   ///< that is all of it
  bool sampled = false;       ///< its surface's samples are in `pixels`: see `sampleSurface`
  bool covered = false;       ///< sampled layers hide all of it, and nothing was drawn
  bool partial = false;       ///< or some of it, which was left out
  bool uploaded = false;      ///< and the atlas has it, too
  PixelRect area;             ///< in pixels of the whole picture
  PixelRect slot;             ///< in the atlas
  PictureContent parts;
  int surfaceStep = 1;  ///< see PictureSettings
  TileMask mask;        ///< where it shows, of the region's grid and within its area
  TileMask touched;     ///< where its strokes look at its surface, too
  std::vector<Stroke> strokes;
  std::vector<Stroke> hidden;              ///< outlines to be seen through what lies before them
  std::vector<Stroke> halos;               ///< where lines behind stop
  std::vector<std::vector<Stroke>> edges;  ///< one list per member
  bool filled = false;
  bool inked = false;
  bool hiddenInk = false;  ///< has `hidden`, also after they were drawn
  bool haloed = false;     ///< has `halos`, as above

  bool shows() const { return !covered && (filled || hasInk()); }
  bool hasInk() const { return inked || hiddenInk || haloed; }
  /// Tells whether what was drawn for `other` serves for this layer too.
  bool drawnLike(const Layer& other) const {
    return members == other.members && area == other.area;
  }
};

/// Says where a layer's surface is drawn: so many pixels of the picture, in a place for one pixel
/// per step.
struct SurfacePlace {
  PixelRect pixels;
  PixelRect slot;
};
/// Returns the place for the layer's area, which begins at `slot` where there is no step.
SurfacePlace surfacePlace(const Layer& layer, const PixelRect& slot);

/// Returns what the resolve pass must know of those layers that show in the region.
std::vector<ListedLayer> listedLayers(std::span<const Layer> layers, const PixelRect& region,
                                      Background background);

/// Returns the layers of the structures (sorted by id) within the region, leaving out those outside
/// it. Areas are known, triangles, strokes and masks are not yet. Only `parts` of the layers will
/// show.
std::vector<Layer> planLayers(std::span<const PreparedStructure> shown, const PictureView& view,
                              const PixelRect& region, const PictureContent& parts);
/// Says where the layer's surface is sampled: at which of the region's samples its place, `slot`,
/// begins.
SampleArea sampledArea(const Layer& layer, const PixelRect& region);
/// Finds the members' triangles within the squares that the layer touches. As they are many, only
/// layers about to be drawn need them, and only until they are drawn.
void findTriangles(Layer& layer, const PictureView& view, const PixelRect& region);
/// Makes the layer's strokes and edges and finds its squares. `lines` has an entry for each member
/// that shows any.
/// What `occlusion` hides of it may be left out; null: nothing.
void completeLayer(Layer& layer, const PictureView& view, const PixelRect& region,
                   const std::map<model::NodeId, StructureLines>& lines,
                   const Occlusion* occlusion);

}  // namespace sline::render
