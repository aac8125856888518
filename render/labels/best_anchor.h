// SPDX-License-Identifier: Apache-2.0
// Chooses where to point at a structure for which the user has given no place.
#pragma once

#include <optional>

#include "render/labels/screen.h"
#include "render/labels/shapes.h"
#include "render/labels/sight.h"

namespace sline::render {

struct BestAnchor {
  model::SurfacePoint point;
  bool hidden = false;  ///< no part of the structure is seen from there
};

/// Returns the place on the structure that is farthest from its ends and from where another
/// structure begins to hide it, as the screen shows it. If there is room for a dot elsewhere, the
/// place is not under a structure that lets it show through either, as its lines would run over the
/// dot. A structure that is hidden completely is treated as if it were alone. Nothing is returned
/// where it is not visible or not in the picture.
std::optional<BestAnchor> bestAnchorOn(const model::Scene& scene, model::NodeId structure,
                                       const Screen& screen, model::MeshTrees& trees);

}  // namespace sline::render
