// SPDX-License-Identifier: Apache-2.0
// What lies under the mouse, by a ray against the meshes. May be asked from any thread, one at a
// time.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "model/geometry/bvh.h"
#include "model/scene/scene.h"

namespace sline::widgets {

struct Pick {
  model::NodeId id;
  glm::vec3 position{0.0f};  ///< millimetres, LPS
};

class PickIndex {
 public:
  /// The nearest structure that is seen there: one whose surface is told by suggestive contours or
  /// more, or that hides what is behind. Where there is none, the nearest of those of which only an
  /// outline is drawn.
  std::optional<Pick> pick(const model::Scene& scene, const model::Ray& ray);

 private:
  /// Made when a ray first comes near; kept while the mesh is in the scene.
  std::mutex m_mutex;
  std::map<model::MeshPtr, std::unique_ptr<model::Bvh>> m_trees;
};

}  // namespace sline::widgets
