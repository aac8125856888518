// SPDX-License-Identifier: Apache-2.0
#include "model/scene/visible_structures.h"

#include <deque>

#include "model/camera/outermost_points.h"
#include "model/cuts/plane_section.h"
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

bool isCutAway(const Scene& scene, const Node& structure) {
  const std::vector<Plane> planes = planesOf(scene.sectionsOf(structure.id));
  return !planes.empty() && keptPoints(*structure.mesh, planes).empty();
}

std::unordered_set<std::uint64_t> annotatedStructures(const Scene& scene) {
  std::unordered_set<std::uint64_t> ids;
  for (const Annotation& annotation : scene.annotations())
    for (const Anchor& anchor : annotation.anchors)
      if (const auto* point = std::get_if<SurfacePoint>(&anchor); point && annotation.visible)
        ids.insert(point->structure.value);
  return ids;
}

namespace {

/// The points of visible structures: those of whole ones, and those that are left of cut ones.
struct VisibleClouds {
  std::vector<PointCloud> clouds;
  std::deque<std::vector<glm::vec3>> left;
};

VisibleClouds visibleClouds(const Scene& scene, std::span<const NodeId> within) {
  std::unordered_set<std::uint64_t> wanted;
  for (const NodeId id : scene.structuresBelow(within))
    wanted.insert(id.value);
  VisibleClouds all;
  for (const VisibleStructure& structure : visibleStructures(scene)) {
    const Node& node = *structure.node;
    if (!wanted.contains(node.id.value))
      continue;
    const std::vector<Plane> planes = planesOf(scene.sectionsOf(node.id));
    if (planes.empty()) {
      all.clouds.push_back({node.mesh->positions(), node.mesh->bounds()});
      continue;
    }
    const std::vector<glm::vec3>& points = all.left.emplace_back(keptPoints(*node.mesh, planes));
    Box box;
    for (const glm::vec3& p : points)
      box.add(p);
    all.clouds.push_back({points, box});
  }
  return all;
}

}  // namespace

std::vector<glm::vec3> visiblePoints(const Scene& scene, std::span<const NodeId> within) {
  const VisibleClouds all = visibleClouds(scene, within);
  std::vector<glm::vec3> points;
  for (const PointCloud& cloud : all.clouds)
    points.insert(points.end(), cloud.points.begin(), cloud.points.end());
  return points;
}

Camera fittedToVisible(const Scene& scene, const Camera& camera, float aspect,
                       const FreeSides& sides, std::span<const NodeId> within) {
  // From a camera of which no picture can be taken, the way back is the front.
  const Camera from = cameraFault(camera) ? Camera() : camera;
  return fitted(from, outermostPoints(from, visibleClouds(scene, within).clouds), aspect, sides);
}

Camera fittedView(const Scene& scene, AnatomicalView view, float aspect, const FreeSides& sides) {
  return fittedToVisible(scene, anatomicalCamera(view, scene.visibleBounds(), aspect), aspect,
                         sides);
}

}  // namespace sline::model
