// SPDX-License-Identifier: Apache-2.0
#include "model/scene/framing.h"

#include <algorithm>

#include "model/scene/camera_moves.h"

namespace sline::model {

Box visibleBounds(const Scene& scene, std::span<const NodeId> ids) {
  Box bounds;
  for (const NodeId id : ids)
    bounds.add(scene.visibleBounds(id));
  return bounds;
}

std::optional<Camera> savedOverview(const Scene& scene) {
  for (const View& view : scene.views())
    if (view.name == "Overview" && !cameraFault(view.camera))
      return view.camera;
  return std::nullopt;
}

Camera withSides(const Camera& saved, float aspect, const FreeSides& sides) {
  constexpr double savedAspect = 4.0 / 3.0;
  constexpr double savedShare = 0.9;  // of the width, as cameras are fitted without labels
  // The camera stays opposite the anatomy's middle, so both sides give as much as one needs.
  const double share = 1.0 - 2.0 * std::max(sides.left, sides.right);
  const double narrow = double(aspect) / savedAspect * std::max(share, 0.1) / savedShare;
  return zoomed(saved, saved.target, float(std::min(1.0, narrow)));
}

}  // namespace sline::model
