// SPDX-License-Identifier: Apache-2.0
#include "model/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "model/camera/camera_moves.h"

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
  if (!(narrow < 1.0))
    return saved;
  // The eye stays where it was, so that nothing comes out from behind another: the picture is the
  // same, with more around it.
  constexpr double widest = 75.0;  // degrees; beyond that things at the edges look stretched
  const double slope = std::tan(glm::radians(0.5 * double(saved.fovyDegrees)));
  const double most = std::max(slope, std::tan(glm::radians(0.5 * widest)));
  const double opened = std::min(slope / narrow, most);
  Camera wider = saved;
  if (saved.projection == Projection::orthographic)
    return zoomed(saved, saved.target, float(narrow));
  wider.fovyDegrees = float(2.0 * glm::degrees(std::atan(opened)));
  return zoomed(wider, saved.target, float(std::min(1.0, narrow * opened / slope)));
}

}  // namespace sline::model
