// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/framing.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "widgets/viewport/tools/navigation.h"

namespace sline::widgets {

model::Box visibleBounds(const model::Scene& scene, std::span<const model::NodeId> ids) {
  model::Box bounds;
  for (const model::NodeId id : ids)
    bounds.add(scene.visibleBounds(id));
  return bounds;
}

std::optional<model::Camera> savedOverview(const model::Scene& scene) {
  for (const model::View& view : scene.views())
    if (view.name == "Overview" && !model::cameraFault(view.camera))
      return view.camera;
  return std::nullopt;
}

model::Camera withSides(const model::Camera& saved, float aspect, const model::FreeSides& sides) {
  constexpr double savedAspect = 4.0 / 3.0;
  constexpr double savedShare = 0.9;  // of the width, as cameras are fitted without labels
  // The camera stays opposite the anatomy's middle, so both sides give as much as one needs.
  const double share = 1.0 - 2.0 * std::max(sides.left, sides.right);
  const double narrow = double(aspect) / savedAspect * std::max(share, 0.1) / savedShare;
  return zoomed(saved, saved.target, float(std::min(1.0, narrow)));
}

bool withinReach(const model::Camera& camera, const glm::vec3& pivot, const model::Scene& scene) {
  const model::Box bounds = scene.visibleBounds();
  const float size = bounds.empty() ? 1000.0f : glm::length(bounds.size());
  const float distance = glm::length(camera.eye - pivot);
  return distance > 1e-3f * size && distance < 50.0f * size;
}

}  // namespace sline::widgets
