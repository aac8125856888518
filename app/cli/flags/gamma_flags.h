// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/gamma_map.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// Holds what was typed after --gamma-by, not yet checked against a scene.
struct GammaMapWish {
  model::GammaMap map;
  std::string target;  ///< the name of what distances are measured to
};

/// Reads "occlusion", "curvature", "distance:STRUCTURE", "painted" or "none", with "@CURVE" where
/// the curve is not the usual one.
Result<GammaMapWish> parseGammaMap(std::string_view text);

/// Returns the map with the ids of its targets.
Result<model::GammaMap> gammaMapIn(const model::Scene& scene, const GammaMapWish& wish);

}  // namespace sline::cli
