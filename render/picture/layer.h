// SPDX-License-Identifier: Apache-2.0
// A structure as a layer of the picture, or all opaque structures together as one (METHOD §10).
#pragma once

#include <map>
#include <vector>

#include "model/scene/scene.h"
#include "render/passes/surface_draw.h"
#include "render/picture/layer_lines.h"
#include "render/picture/layer_sections.h"
#include "render/picture/picture.h"
#include "render/picture/surface_cache.h"
#include "render/picture/tile_lists.h"

namespace sline::render {

/// A structure to draw: what of it decides its pixels besides the camera.
struct Shown {
  model::NodeId id;
  model::MeshPtr mesh;
  model::ResolvedStyle style;
  CachedSurface* cached = nullptr;
  bool printedHatching = false;           ///< hatched as S prints it
  std::vector<model::Section> sections;   ///< that cut it
  std::shared_ptr<SectionedSurface> cut;  ///< by these; null where there are none

  bool operator==(const Shown& other) const {
    return id == other.id && mesh == other.mesh && style == other.style &&
           printedHatching == other.printedHatching && alike(sections, other.sections);
  }
  const model::Surface& surface() const { return *cached->surface; }
};

/// What of a surface can be seen, from its clusters alone.
struct Coverage {
  gpu::Rect area;  ///< pixels of the whole picture that the surface or its strokes can touch
  std::vector<gpu::DrawRange> ranges;  ///< of a surface with two sides
  std::vector<std::uint32_t> visible;  ///< of one with an outside only: see `findVisible`
};

struct Layer {
  std::vector<Shown> members;  ///< one, or by id all that are opaque and without lines
  std::vector<Coverage> coverage;
  gpu::Rect area;  ///< in pixels of the whole picture
  gpu::Rect slot;  ///< in the atlas
  PictureParts parts;
  TileMask mask;
  std::vector<passes::InkSegment> strokes;
  std::vector<std::vector<passes::InkSegment>> edges;  ///< of each member
  bool filled = false;
  bool inked = false;

  bool shows() const { return filled || inked; }
  /// True where what was drawn for `other` serves for this one too.
  bool drawnLike(const Layer& other) const {
    return members == other.members && area == other.area;
  }
};

/// From 0 to 1 in each of red, green and blue, encoded as sRGB.
inline glm::vec3 rgb(const Colour& colour) {
  return glm::vec3(float(colour.red), float(colour.green), float(colour.blue)) / 255.0f;
}
/// sRGB, straight alpha.
glm::vec4 backgroundColour(Background background);
/// The pen's colour: the style's own, else black, on a dark background nearly white.
Colour inkColour(const model::ResolvedStyle& style, Background background);

/// True for structures that hide what is behind and have no lines: they share one layer.
bool isOpaque(const model::ResolvedStyle& style);
bool hasFill(const model::ResolvedStyle& style);
passes::SurfaceFill surfaceFill(const Shown& shown, const PictureView& view, Background background);

/// Finds which parts of the surface show within `region`, but for single triangles.
Coverage coverage(const Shown& shown, const PictureView& view, const gpu::Rect& region);

/// Layers of the structures (sorted by id) within the region, those outside of it left out: areas
/// and ranges are known, strokes and masks are not yet. Only `parts` of them will show.
std::vector<Layer> planLayers(std::span<const Shown> shown, const PictureView& view,
                              const gpu::Rect& region, const PictureParts& parts);
/// Finds the triangles that face the eye, as indices, where members have an outside only. They are
/// many: only layers about to be drawn need them, and only until they are.
void findVisible(Layer& layer, const PictureView& view, const gpu::Rect& region);
/// Makes the layer's strokes and edges and finds its tiles. `lines` has an entry for each member
/// that shows any.
void completeLayer(Layer& layer, const PictureView& view, const gpu::Rect& region,
                   const std::map<model::NodeId, StructureLines>& lines);

}  // namespace sline::render
