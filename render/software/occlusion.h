// SPDX-License-Identifier: Apache-2.0
// Knows how far squares of a picture are seen: what lies wholly behind opaque surfaces need not be
// drawn, nor its lines be found (N. Greene et al., "Hierarchical Z-Buffer Visibility", 1993).
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_view.h"
#include "render/raster/pixel_rect.h"
#include "render/raster/tile_mask.h"
#include "render/software/layer_pixels.h"
#include "render/strokes/stroke.h"

namespace sline::render {

class Occlusion {
 public:
  /// Takes the picture's part that is drawn.
  Occlusion(const PictureView& view, const PixelRect& region);

  /// Takes the surface samples of a layer in, whose pixels have not been enlarged yet.
  void add(const LayerPixels& pixels);
  /// Tells whether opaque surfaces hide everything that the structure may draw. Structures that are
  /// cut are never hidden.
  bool hides(const DrawnStructure& shown) const;
  /// Tells whether they hide all that the structure may draw of a cluster of its surface, and so
  /// many pixels around it.
  bool hides(const model::Surface& surface, const model::Cluster& cluster, int around) const;
  /// Tells whether they hide a stroke on the surface, with so many pixels around it.
  bool hides(const model::Surface& surface, const Stroke& stroke, int around = 0) const;
  /// Takes the marks from squares where a layer whose surface is sampled shows nothing of it.
  /// Returns whether something is there that is hidden.
  bool unmarkHidden(const LayerPixels& pixels, TileMask& mask) const;

 private:
  /// Returns whether each of these pixels, those outside the region apart, shows something opaque
  /// no farther than so many mm from the eye's plane.
  bool covers(const PixelRect& pixels, float distance) const;

  const PictureView& m_view;
  PixelRect m_region;
  int m_columns;
  int m_rows;
  std::vector<float> m_farthest;  ///< mm from the eye's plane, by square; infinity: seen to the end
};

}  // namespace sline::render
