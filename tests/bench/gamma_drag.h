// SPDX-License-Identifier: Apache-2.0
// Measures what a drag of one structure's Γ costs, against a full frame of the same scene.
#pragma once

#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/picture/picture.h"
#include "tests/bench/measure.h"

namespace sline::bench {

struct DraggedStructure {
  std::string name;
  std::size_t triangles = 0;
  double firstMs = 0.0;  ///< the dearest step: the first that needs strokes lays them
  Spread step;
  Spread full;         ///< frames that draw every layer, taken in between
  int mostLayers = 0;  ///< drawn by any step after the first
  /// Holds the time that each part of a step took at the median.
  std::vector<std::pair<std::string, double>> passes;

  double ratio() const { return full.median > 0.0 ? step.median / full.median : 0.0; }
};

struct GammaDragPlan {
  const model::Scene& scene;
  model::Camera camera;
  render::PictureSettings settings;
  int structures = 8;  ///< the largest, and as many spread over the rest
  float step = 0.1f;   ///< step of Γ, from 0 to 5
};

/// Drags one structure after the other from silhouette to surface and back to where it was.
Result<std::vector<DraggedStructure>> dragGamma(render::Picture& picture,
                                                const GammaDragPlan& plan);

std::string asText(const std::vector<DraggedStructure>& dragged);

}  // namespace sline::bench
