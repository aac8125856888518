// SPDX-License-Identifier: Apache-2.0
// Holds the cut faces of a layer as the GPU draws them.
#pragma once

#include <memory>
#include <vector>

#include "render/drawn/picture_settings.h"
#include "render/drawn/picture_view.h"
#include "render/drawn/sectioned_surface.h"
#include "render/passes/cap/cap_pass.h"
#include "render/picture/surfaces/tile_lists.h"

namespace sline::render {

struct PreparedStructure;

/// A cut surface with what the GPU holds of its faces.
struct CappedSurface : SectionedSurface {
  explicit CappedSurface(SectionedSurface&& cut)
      : SectionedSurface(std::move(cut)), caps(faces.size()) {}
  std::vector<std::unique_ptr<passes::CapGeometry>> caps;  ///< one per face, once drawn
};

void markCaps(const PreparedStructure& shown, const PictureView& view, TileMask& mask);

/// Holds one draw per face, as `capDraws` returns them; it makes the geometry where it is missing.
/// `area` and `slot` are the layer's; the sections that clip each face point into `planes`.
struct CapDraws {
  std::vector<std::vector<glm::vec4>> planes;
  std::vector<passes::CapDraw> draws;
};
CapDraws capDraws(const PreparedStructure& shown, const PictureView& view, Background background,
                  const PixelRect& area, const PixelRect& slot);

}  // namespace sline::render
