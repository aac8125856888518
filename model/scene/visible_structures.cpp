// SPDX-License-Identifier: Apache-2.0
#include "model/scene/visible_structures.h"

#include <algorithm>

#include "model/geometry/plane_section.h"
#include "model/scene/resolved_styles.h"

namespace sline::model {

std::vector<VisibleStructure> visibleStructures(const Scene& scene) {
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  std::vector<VisibleStructure> visible;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const Node& node = scene.nodes()[i];
    if (!node.isGroup() && styles[i].visible && node.mesh->triangleCount() > 0)
      visible.push_back({&node, styles[i]});
  }
  return visible;
}

std::unordered_set<std::uint64_t> annotatedStructures(const Scene& scene) {
  std::unordered_set<std::uint64_t> ids;
  for (const Annotation& annotation : scene.annotations())
    for (const Anchor& anchor : annotation.anchors)
      if (const auto* point = std::get_if<SurfacePoint>(&anchor); point && annotation.visible)
        ids.insert(point->structure.value);
  return ids;
}

std::vector<glm::vec3> visiblePoints(const Scene& scene, std::span<const NodeId> within) {
  const auto wanted = [&](NodeId id) {
    return std::any_of(within.begin(), within.end(), [&](NodeId ancestor) {
      return ancestor == rootId || scene.isBelow(id, ancestor);
    });
  };
  std::vector<glm::vec3> points;
  for (const VisibleStructure& structure : visibleStructures(scene)) {
    if (!wanted(structure.node->id))
      continue;
    const std::vector<glm::vec3> kept =
        keptPoints(*structure.node->mesh, planesOf(scene.sectionsOf(structure.node->id)));
    points.insert(points.end(), kept.begin(), kept.end());
  }
  return points;
}

Camera fittedToVisible(const Scene& scene, const Camera& camera, float aspect,
                       const FreeSides& sides, std::span<const NodeId> within) {
  return fitted(camera, visiblePoints(scene, within), aspect, sides);
}

Camera fittedView(const Scene& scene, AnatomicalView view, float aspect, const FreeSides& sides) {
  return fittedToVisible(scene, anatomicalCamera(view, scene.visibleBounds(), aspect), aspect,
                         sides);
}

}  // namespace sline::model
