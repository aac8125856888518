// SPDX-License-Identifier: Apache-2.0
// Finds where the points of strokes that lie on a surface are seen in a picture.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "model/geometry/clusters.h"
#include "render/lines/ground/view_scale.h"
#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

/// Describes from where strokes are seen.
struct PlacesView {
  const ViewScale& scale;
  const model::EyePoint& eye;
  glm::vec2 farthest{
      0.0f};  ///< from the middle of the picture, λ: points farther away are left out
};

/// Holds what is known of each point of a stroke, in rows as long as the tile's (foreshortening.h).
struct HatchPlaces {
  std::vector<float> x;  ///< λ
  std::vector<float> y;
  /// The share of the distance to neighbouring strokes that is seen (`seenAcross`).
  std::vector<float> across;
  /// How many λ a millimetre between strokes takes, as far as it decides which levels show
  /// (`widened`); 0 where a point is left out.
  std::vector<float> perMm;

  /// Finds it for a stroke of the tile; `facing` has a row of nv.
  void find(const LaidTile& tile, const LaidStroke& stroke, const PlacesView& view,
            const std::vector<float>& facing);
};

}  // namespace sline::render
