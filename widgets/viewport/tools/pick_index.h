// SPDX-License-Identifier: Apache-2.0
// What lies under the mouse, by rays against the meshes. May be asked from any thread, one at a
// time.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "model/geometry/mesh_trees.h"
#include "model/scene/scene.h"

namespace sline::widgets {

struct Pick {
  model::NodeId id;
  glm::vec3 position{0.0f};  ///< millimetres, LPS
};

/// What is found at a place of the picture.
struct Picks {
  std::optional<Pick> seen;  ///< what a person means who points there
  std::vector<Pick> all;     ///< each structure once, nearest first
  /// Of what is seen, where it was asked for.
  std::optional<model::Anchor> anchor;
};

class PickIndex {
 public:
  /// The first ray goes through the place itself, the others pass around it: a structure of which
  /// only an outline is drawn is seen where its outline passes between them. Directions are unit
  /// vectors.
  ///
  /// Seen is, in this order: an outline that is not hidden; the nearest structure that is solid
  /// there (told by suggestive contours or more, or hiding what is behind it); a solid one at whose
  /// edge the place is; the nearest that is veiled or thin; the nearest within whose outline the
  /// place is. What is hidden, locked or cut away is not there.
  Picks look(const model::Scene& scene, std::span<const model::Ray> rays);

 private:
  std::mutex m_mutex;
  model::MeshTrees m_trees;  ///< of structures that a ray came near
};

/// Steps deeper through what is found at one place: what comes after the one that is selected, the
/// nearest where none of them or several are, and after the last the first again.
std::optional<Pick> deeper(const std::vector<Pick>& all, std::span<const model::NodeId> selection);

}  // namespace sline::widgets
