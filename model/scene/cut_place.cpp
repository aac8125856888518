// SPDX-License-Identifier: Apache-2.0
#include "model/scene/cut_place.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/nearest_point.h"

namespace sline::model {

const glm::vec3* cutPlaceOf(const Annotation& annotation) {
  const bool both = annotation.kind != AnnotationKind::distance && annotation.anchors.size() == 2;
  return both ? std::get_if<glm::vec3>(&annotation.anchors[1]) : nullptr;
}

std::vector<Anchor> anchorsOnCut(const Node& structure, const glm::vec3& place) {
  const auto nearest = structure.mesh ? nearestPoint(*structure.mesh, place) : std::nullopt;
  if (!nearest)
    return {place};
  return {SurfacePoint{structure.id, nearest->triangle, nearest->weights}, place};
}

std::span<const Anchor> pointedAt(const Annotation& annotation) {
  const std::span<const Anchor> all = annotation.anchors;
  return cutPlaceOf(annotation) ? all.last(1) : all;
}

bool cutsThrough(const Scene& scene, NodeId structure, const glm::vec3& place) {
  const Node* node = scene.find(structure);
  if (!node || !node->mesh)
    return false;
  // Places that were picked lie on the plane but for the rounding of their coordinates.
  constexpr float rounding = 1e-3f;
  const float near = rounding * glm::length(node->mesh->bounds().size());
  bool on = false;
  for (const Plane& plane : planesOf(scene.sectionsOf(structure))) {
    const float beyond = glm::dot(plane.normal, place) - plane.offset;
    if (beyond > near)
      return false;
    on = on || std::abs(beyond) <= near;
  }
  return on;
}

}  // namespace sline::model
