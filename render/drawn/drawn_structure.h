// SPDX-License-Identifier: Apache-2.0
// Holds everything about a structure that decides how it looks, besides the camera.
#pragma once

#include <memory>
#include <vector>

#include "model/anatomy/cut_pattern.h"
#include "model/scene/scene.h"
#include "render/drawn/prepared_surface.h"
#include "render/drawn/sectioned_surface.h"
#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

struct DrawnStructure {
  model::NodeId id;
  model::MeshPtr mesh;
  model::ResolvedStyle style;
  PreparedSurface* prepared = nullptr;
  std::vector<model::Section> sections;         ///< the sections that cut it
  std::shared_ptr<const SectionedSurface> cut;  ///< cut by these; null where there are none

  /// How its cut faces are drawn where the section shows tissue.
  model::CutPattern pattern = model::CutPattern::plain;

  /// The most cells of hatching to look at: its share of what the picture may.
  std::size_t hatchCells = mostHatchCells;

  GammaOffsetsPtr gammaOffsets;  ///< null where Γ is the same all over it

  const model::Surface& surface() const { return *prepared->surface; }
};

}  // namespace sline::render
