// SPDX-License-Identifier: Apache-2.0
// Puts labels on structures and shows them in one picture.
#pragma once

#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render/labels/anchors.h"

namespace sline::test {

/// Labels the structure where it reaches farthest that way.
inline model::AnnotationId point(model::Scene& scene, model::NodeId node,
                                 const glm::vec3& towards) {
  const model::Mesh& mesh = *scene.find(node)->mesh;
  std::uint32_t best = 0;
  float farthest = -1e9f;
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
    const float along = glm::dot(model::placeOn(mesh, {node, i, {0.3f, 0.3f}}), towards);
    if (along > farthest) {
      farthest = along;
      best = i;
    }
  }
  return scene.appendAnnotation(
      {.anchors = {model::SurfacePoint{node, best, {0.3f, 0.3f}}}, .text = "text"});
}

inline model::Camera front() {
  return {.eye = {0.0f, -400.0f, 0.0f}};
}

inline constexpr glm::vec2 paper{240.0f, 180.0f};

/// Returns the labels as that camera shows them on the paper.
inline std::vector<render::ShownLabel> shown(const model::Scene& scene,
                                             const std::string& language = {}) {
  model::MeshTrees trees;
  return render::shownLabels(scene, render::Screen(front(), paper), language, trees);
}

}  // namespace sline::test
