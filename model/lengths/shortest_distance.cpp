// SPDX-License-Identifier: Apache-2.0
#include "model/lengths/shortest_distance.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "model/geometry/shortest_way.h"
#include "model/lengths/measured_extent.h"

namespace sline::model {

namespace {

std::optional<ShortestWay> wayFrom(const glm::vec3& at, const Mesh& from, const Mesh& to) {
  const std::optional<PointOnMesh> start = nearestPoint(from, at);
  const std::optional<PointOnMesh> end = start ? nearestPoint(to, start->place) : std::nullopt;
  return end ? std::optional(ShortestWay{*start, *end}) : std::nullopt;
}

/// Returns below which length two structures touch: no surface is exact to a tenth of a millimetre
/// of a body, nor to a thousandth of a cell.
float touchingLength(const Scene& scene, const Annotation& annotation) {
  float least = 0.05f;
  constexpr float exactness = 1.0f / 2000.0f;
  for (const Anchor& anchor : annotation.anchors)
    if (const auto* point = std::get_if<SurfacePoint>(&anchor))
      if (const Node* node = scene.find(point->structure); node && node->mesh)
        least = std::min(least, exactness * glm::length(node->mesh->bounds().size()));
  return least;
}

/// Returns how far import has moved the surfaces on which the ends lie, at most and in all.
float movedByImport(const Scene& scene, const Annotation& annotation) {
  float moved = 0.0f;
  for (const Anchor& anchor : annotation.anchors)
    if (const auto* point = std::get_if<SurfacePoint>(&anchor))
      if (const Node* node = scene.find(point->structure))
        moved += movedMm(node->provenance);
  return moved;
}

}  // namespace

std::optional<DrawnLength> drawnLength(const Scene& scene, const Annotation& annotation) {
  if (annotation.kind != AnnotationKind::distance)
    return std::nullopt;
  const auto from = scene.placeOf(annotation.anchors.front());
  const auto to = scene.placeOf(annotation.anchors.back());
  if (!from || !to)
    return std::nullopt;
  const float length = glm::distance(*from, *to);
  return DrawnLength{.mm = length < touchingLength(scene, annotation) ? 0.0f : length,
                     .offMm = movedByImport(scene, annotation)};
}

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
