// SPDX-License-Identifier: Apache-2.0
// A structure as a layer of the picture, or all opaque structures together as one (METHOD §10).
#pragma once

#include <map>
#include <vector>

#include "model/scene/scene.h"
#include "render/gpu/device.h"
#include "render/picture/layer_caps.h"
#include "render/picture/surface_cache.h"
#include "render/picture/tile_lists.h"
#include "render/strokes/drawn_structure.h"
#include "render/strokes/picture_settings.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

/// A structure to draw, with what the GPU has of it.
struct Shown : DrawnStructure {
  CachedSurface* cached = nullptr;        ///< `prepared`, too
  bool printedHatching = false;           ///< hatched as S prints it
  std::shared_ptr<CappedSurface> capped;  ///< `cut`, too

  bool operator==(const Shown& other) const {
    return id == other.id && mesh == other.mesh && style == other.style &&
           printedHatching == other.printedHatching && alike(sections, other.sections);
  }
};

/// What of a surface can be seen, from its clusters alone.
struct Coverage {
  PixelRect area;  ///< pixels of the whole picture that the surface or its strokes can touch
  std::vector<gpu::DrawRange> ranges;  ///< of a surface with two sides
  std::vector<std::uint32_t> visible;  ///< of one with an outside only: see `findVisible`
};

struct Layer {
  std::vector<Shown> members;  ///< one, or by id all that are opaque and without lines
  std::vector<Coverage> coverage;
  PixelRect area;  ///< in pixels of the whole picture
  PixelRect slot;  ///< in the atlas
  PictureParts parts;
  TileMask mask;
  std::vector<Stroke> strokes;
  std::vector<std::vector<Stroke>> edges;  ///< of each member
  bool filled = false;
  bool inked = false;

  bool shows() const { return filled || inked; }
  /// True where what was drawn for `other` serves for this one too.
  bool drawnLike(const Layer& other) const {
    return members == other.members && area == other.area;
  }
};

/// Finds which parts of the surface show within `region`, but for single triangles.
Coverage coverage(const Shown& shown, const PictureView& view, const PixelRect& region);

/// Layers of the structures (sorted by id) within the region, those outside of it left out: areas
/// and ranges are known, strokes and masks are not yet. Only `parts` of them will show.
std::vector<Layer> planLayers(std::span<const Shown> shown, const PictureView& view,
                              const PixelRect& region, const PictureParts& parts);
/// Finds the triangles that face the eye, as indices, where members have an outside only. They are
/// many: only layers about to be drawn need them, and only until they are.
void findVisible(Layer& layer, const PictureView& view, const PixelRect& region);
/// Makes the layer's strokes and edges and finds its tiles. `lines` has an entry for each member
/// that shows any.
void completeLayer(Layer& layer, const PictureView& view, const PixelRect& region,
                   const std::map<model::NodeId, StructureLines>& lines);

}  // namespace sline::render
