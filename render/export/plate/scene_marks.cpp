// SPDX-License-Identifier: Apache-2.0
// Tells what of a scene marks are about.
#include <algorithm>

#include "render/export/plate/marks.h"

namespace sline::render {

namespace {

bool visibleIn(const model::Scene& scene, const model::Node& node) {
  return !node.isGroup() && scene.resolve(node.id).visible;
}

bool takesAway(const model::Plane& plane, const model::Box& box) {
  const auto corners = box.corners();
  return std::any_of(corners.begin(), corners.end(),
                     [&](const glm::vec3& corner) { return !plane.keeps(corner); });
}

}  // namespace

bool hasLabels(const model::Scene& scene) {
  const auto& annotations = scene.annotations();
  return std::any_of(annotations.begin(), annotations.end(),
                     [](const model::Annotation& annotation) { return annotation.visible; });
}

std::vector<const model::Section*> sectionsSeen(const model::Scene& scene) {
  std::vector<const model::Section*> seen;
  for (const model::Section& section : scene.sections()) {
    const auto cuts = [&](const model::Node& node) {
      return visibleIn(scene, node) && !node.mesh->bounds().empty() &&
             (section.scope == model::rootId || scene.isBelow(node.id, section.scope)) &&
             takesAway(section.plane, node.mesh->bounds());
    };
    if (section.enabled && std::any_of(scene.nodes().begin(), scene.nodes().end(), cuts))
      seen.push_back(&section);
  }
  return seen;
}

}  // namespace sline::render
