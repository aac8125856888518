// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/edit/look.h"
#include "model/meshing/loop_subdivision.h"

namespace sline::bench {

model::Scene withGamma(const model::Scene& scene, std::optional<float> gamma) {
  std::vector<model::NodeId> ids = scene.structuresBelow(model::rootId);
  std::sort(ids.begin(), ids.end(), [&](model::NodeId a, model::NodeId b) {
    return scene.find(a)->name < scene.find(b)->name;
  });
  model::Scene result = scene;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const float share = ids.size() > 1 ? float(i) / float(ids.size() - 1) : 0.0f;
    const model::Style patch{.gamma = Gamma::clamped(gamma.value_or(5.0f * share)),
                             .visible = true};
    result = model::withLook(result, std::span(&ids[i], 1), patch).scene;
  }
  return result;
}

model::Scene subdivided(const model::Scene& scene) {
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (node.mesh) {
      model::Subdivided fine =
          model::loopSubdivided({node.mesh->positions().begin(), node.mesh->positions().end()},
                                {node.mesh->triangles().begin(), node.mesh->triangles().end()});
      node.mesh = std::make_shared<const model::Mesh>(
          std::move(model::Mesh::create(std::move(fine.positions), std::move(fine.triangles)))
              .value());
    }
  model::Scene result = scene;
  result.setNodes(std::move(nodes));
  return result;
}

model::Camera turned(const model::Camera& start, float share) {
  const float angle = 2.0f * 3.14159265f * share;
  const glm::vec3 d = start.eye - start.target;
  model::Camera camera = start;
  camera.eye = start.target + glm::vec3(std::cos(angle) * d.x - std::sin(angle) * d.y,
                                        std::sin(angle) * d.x + std::cos(angle) * d.y, d.z);
  return camera;
}

}  // namespace sline::bench
