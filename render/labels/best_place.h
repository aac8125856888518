// SPDX-License-Identifier: Apache-2.0
// Where to point at a structure that nobody has pointed at.
#pragma once

#include <optional>

#include "render/labels/screen.h"
#include "render/labels/shapes.h"
#include "render/labels/sight.h"

namespace sline::render {

struct BestPlace {
  model::SurfacePoint point;
  bool hidden = false;  ///< nothing of the structure is seen from there
};

/// The place on the structure farthest from where it ends, or another structure begins to hide it,
/// as the screen shows it, and if there is room for a dot not under what lets it show through
/// either: its lines would run over the dot. Of a structure that is all hidden, as if it were
/// alone. Nothing where it is not visible or not in the picture.
std::optional<BestPlace> bestPlaceOn(const model::Scene& scene, model::NodeId structure,
                                     const Screen& screen, model::MeshTrees& trees);

}  // namespace sline::render
