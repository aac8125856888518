// SPDX-License-Identifier: Apache-2.0
#include "model/scene/shortest_distance.h"

#include "model/geometry/shortest_way.h"

namespace sline::model {

namespace {

std::optional<ShortestWay> wayFrom(const glm::vec3& at, const Mesh& from, const Mesh& to) {
  const std::optional<PointOnMesh> start = nearestPoint(from, at);
  const std::optional<PointOnMesh> end = start ? nearestPoint(to, start->place) : std::nullopt;
  return end ? std::optional(ShortestWay{*start, *end}) : std::nullopt;
}

}  // namespace

std::optional<Annotation> shortestDistance(const Scene& scene, NodeId from, NodeId to,
                                           const std::optional<glm::vec3>& at) {
  const Node* first = scene.find(from);
  const Node* second = scene.find(to);
  if (!first || !second || first->isGroup() || second->isGroup())
    return std::nullopt;
  const std::optional<ShortestWay> way =
      at ? wayFrom(*at, *first->mesh, *second->mesh) : shortestWay(first->mesh, second->mesh);
  if (!way)
    return std::nullopt;
  Annotation distance{.kind = AnnotationKind::distance};
  distance.anchors = {SurfacePoint{from, way->from.triangle, way->from.weights},
                      SurfacePoint{to, way->to.triangle, way->to.weights}};
  return distance;
}

}  // namespace sline::model
