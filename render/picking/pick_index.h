// SPDX-License-Identifier: Apache-2.0
// Finds what lies under the mouse, by rays against the meshes. May be called from any thread, one
// call at a time.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/mesh_trees.h"
#include "model/scene/scene.h"

namespace sline::render {

struct Pick {
  model::NodeId id;
  glm::vec3 position{0.0f};  ///< millimetres, LPS
};

/// Holds what is found at a place of the picture.
struct Picks {
  std::optional<Pick> seen;  ///< the structure that the user means by pointing there
  std::vector<Pick> all;     ///< each structure once, nearest first
  /// The anchor on the seen structure, if it was requested.
  std::optional<model::Anchor> anchor;
};

/// Returns rays through the pixel at which the user points and around it, within which lines count.
std::vector<model::Ray> sightsAround(const model::Camera& camera, const glm::vec2& pixel,
                                     const glm::vec2& size);

class PickIndex {
 public:
  /// Finds the structures that the rays hit. The first ray goes through the place itself, the
  /// others pass around it: a structure of which only an outline is drawn is seen where its outline
  /// passes between them. Directions are unit vectors.
  ///
  /// The seen structure is, in this order: a line's that is not hidden; the nearest structure that
  /// is solid there, whose fill hides at least 35 % of what is behind it; the nearest that is drawn
  /// by suggestive contours or more but lets more through; a solid one with its edge at the place;
  /// the nearest that is veiled or thin; the nearest that has the place within its outline.
  /// Structures that are hidden, locked or cut away are ignored. Cut faces are solid unless they
  /// are thin, and of those of one cut the innermost is nearest, as in pictures.
  Picks pick(const model::Scene& scene, std::span<const model::Ray> rays);

  /// Describes a box of the picture; pixels as in `Pointer`.
  struct Box {
    model::Camera camera;
    glm::vec2 size{1.0f};  ///< of the picture
    glm::vec2 low{0.0f};
    glm::vec2 high{0.0f};
    bool touching = false;  ///< else only what lies wholly within counts
  };
  /// Returns the structures in the box of which some place in it is not behind a solid one, in tree
  /// order.
  std::vector<model::NodeId> inBox(const model::Scene& scene, const Box& box);

 private:
  /// Returns by how many steps the structure's cut face lies in front (faceSteps), if the ray meets
  /// one.
  std::optional<float> faceAt(const model::Scene& scene, const model::Node& node,
                              std::span<const model::Plane> planes, const model::Ray& ray);

  std::mutex m_mutex;
  model::MeshTrees m_trees;  ///< of structures that a ray came near
};

/// Steps deeper through what is found at one place: returns the structure after the selected one,
/// the nearest where none of them or several are selected, and after the last the first again.
std::optional<Pick> nextDeeper(const std::vector<Pick>& all,
                               std::span<const model::NodeId> selection);

}  // namespace sline::render
