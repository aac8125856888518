// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/framing.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "model/scene/resolved_styles.h"
#include "widgets/viewport/tools/navigation.h"

namespace sline::widgets {

namespace {

constexpr std::array<model::NodeId, 1> everything{model::rootId};

/// Returns the corners of each structure's box, because a whole body has too many vertices to look
/// at within a frame.
std::vector<glm::vec3> visibleCorners(const model::Scene& scene,
                                      std::span<const model::NodeId> ids) {
  std::vector<glm::vec3> corners;
  for (const model::ResolvedStructure& structure : model::resolvedBelow(scene, ids))
    if (structure.style.visible && structure.node->mesh->triangleCount() > 0) {
      const auto all = structure.node->mesh->bounds().corners();
      corners.insert(corners.end(), all.begin(), all.end());
    }
  return corners;
}

}  // namespace

model::Box visibleBounds(const model::Scene& scene, std::span<const model::NodeId> ids) {
  model::Box bounds;
  for (const model::NodeId id : ids)
    bounds.add(scene.visibleBounds(id));
  return bounds;
}

model::Camera fitted(const model::Camera& camera, const model::Scene& scene,
                     std::span<const model::NodeId> ids, float aspect) {
  return model::fitted(camera, visibleCorners(scene, ids), aspect);
}

model::Camera cameraFrom(const model::Scene& scene, model::AnatomicalView view, float aspect) {
  return fitted(model::anatomicalCamera(view, scene.visibleBounds(), aspect), scene, everything,
                aspect);
}

model::Camera overview(const model::Scene& scene, float aspect) {
  // Views are saved for pictures of 4:3; in a narrower window the camera steps back so that the
  // sides stay in.
  const float narrow = std::min(1.0f, aspect * 3.0f / 4.0f);
  for (const model::View& view : scene.views())
    if (view.name == "Overview" && !model::cameraFault(view.camera))
      return zoomed(view.camera, view.camera.target, narrow);
  return cameraFrom(scene, model::AnatomicalView::anterior, aspect);
}

bool withinReach(const model::Camera& camera, const glm::vec3& pivot, const model::Scene& scene) {
  const model::Box bounds = scene.visibleBounds();
  const float size = bounds.empty() ? 1000.0f : glm::length(bounds.size());
  const float distance = glm::length(camera.eye - pivot);
  return distance > 1e-3f * size && distance < 50.0f * size;
}

}  // namespace sline::widgets
