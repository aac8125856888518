// SPDX-License-Identifier: Apache-2.0
// What is seen along a line of sight, and what is hidden. What is transparent hides nothing: a
// structure without a fill or shading, a tinted or veiled one, and one that is more clear than not.
#pragma once

#include <optional>
#include <vector>

#include "model/geometry/mesh_trees.h"
#include "model/geometry/plane.h"
#include "model/scene/scene.h"

namespace sline::render {

/// One scene as it is drawn. The scene and the trees must outlive this.
class Sights {
 public:
  Sights(const model::Scene& scene, model::MeshTrees& trees);

  struct Seen {
    model::NodeId structure;
    model::Hit hit;
    bool cutFace = false;  ///< a section's, where the hit is the ray's entrance
  };
  /// The nearest that hides what is behind it, sections taken into account.
  std::optional<Seen> nearest(const model::Ray& ray) const;
  /// The nearest of that structure alone, whether it hides anything or not.
  std::optional<Seen> nearestOf(model::NodeId structure, const model::Ray& ray) const;
  /// Another structure that is drawn is on the ray, whether it hides anything or not.
  bool drawnOver(model::NodeId structure, const model::Ray& ray) const;
  /// Meshes without which `hidden` would have to wait for a tree.
  std::vector<model::MeshPtr> withoutTree() const;
  /// Visible, and not taken away by a section.
  bool shows(const model::Anchor& anchor) const;
  /// Something that hides is before the place; `ray` must go through it. Its own structure counts
  /// where it is more than 1/200 of its size nearer.
  bool hidden(const model::Anchor& anchor, const model::Ray& ray) const;

 private:
  struct Body {
    const model::Node* node;
    std::vector<model::Plane> planes;
    bool hides;
  };
  const Body* find(model::NodeId id) const;
  std::optional<Seen> meet(const Body& body, const model::Ray& ray) const;

  const model::Scene& m_scene;
  model::MeshTrees& m_trees;
  std::vector<Body> m_bodies;  ///< the visible ones
};

}  // namespace sline::render
