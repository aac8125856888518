// SPDX-License-Identifier: Apache-2.0
#include "model/scene/annotation.h"

#include <algorithm>
#include <cmath>

namespace sline::model {

namespace {
/// Measured in heights of the picture.
constexpr float farthestOffset = 100.0f;

bool isSound(const Anchor& anchor) {
  if (const auto* place = std::get_if<glm::vec3>(&anchor))
    return std::isfinite(place->x) && std::isfinite(place->y) && std::isfinite(place->z);
  const auto& [second, third] = std::get<SurfacePoint>(anchor).weights;
  // Rounded barycentric weights may sum to a little more than 1.
  constexpr float most = 1.0f + 1e-5f;
  return second >= 0.0f && third >= 0.0f && second + third <= most;
}
}  // namespace

std::size_t anchorCount(AnnotationKind kind) {
  return kind == AnnotationKind::distance ? 2 : 1;
}

const std::string& textIn(const Annotation& annotation, const std::string& language) {
  const auto found = annotation.texts.find(language);
  return found == annotation.texts.end() ? annotation.text : found->second;
}

glm::vec3 placeOn(const Mesh& mesh, const SurfacePoint& point) {
  const Triangle& corners = mesh.triangles()[point.triangle];
  const auto& [second, third] = point.weights;
  return (1.0f - second - third) * mesh.positions()[corners[0]] +
         second * mesh.positions()[corners[1]] + third * mesh.positions()[corners[2]];
}

std::optional<std::string_view> annotationFault(const Annotation& annotation) {
  // One on a face of a cut has two (cut_place.h).
  const bool onCut = annotation.kind != AnnotationKind::distance &&
                     annotation.anchors.size() == 2 &&
                     std::holds_alternative<SurfacePoint>(annotation.anchors.front()) &&
                     std::holds_alternative<glm::vec3>(annotation.anchors.back());
  if (annotation.anchors.size() != anchorCount(annotation.kind) && !onCut)
    return "a distance has two places, any other annotation one";
  if (!std::all_of(annotation.anchors.begin(), annotation.anchors.end(), isSound))
    return "its place is no point in space, and none in a triangle";
  if (annotation.offset && !(std::abs(annotation.offset->x) <= farthestOffset &&
                             std::abs(annotation.offset->y) <= farthestOffset))
    return "its text is farther away than any picture is wide";
  return std::nullopt;
}

}  // namespace sline::model
