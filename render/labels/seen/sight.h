// SPDX-License-Identifier: Apache-2.0
// Finds what is seen along a line of sight, and what is hidden. Transparent things hide nothing: a
// structure without a fill or shading, a tinted or veiled one, and one that is more clear than not.
// Cut faces hide what is behind them whatever the structure's fill.
#pragma once

#include <optional>
#include <vector>

#include "model/geometry/mesh_trees.h"
#include "model/geometry/plane.h"
#include "model/scene/scene.h"

namespace sline::render {

/// Looks at one scene as it is drawn. The scene and the trees must outlive this object.
class Sights {
 public:
  Sights(const model::Scene& scene, model::MeshTrees& trees);

  struct SightHit {
    model::NodeId structure;
    model::Hit hit;
    bool cutFace = false;  ///< that of a section, where the hit is the ray's entrance
  };
  /// Returns the nearest structure that hides what is behind it, taking sections into account.
  std::optional<SightHit> nearest(const model::Ray& ray) const;
  /// Returns the nearest hit of that structure alone, whether it hides anything or not.
  std::optional<SightHit> nearestOf(model::NodeId structure, const model::Ray& ray) const;
  /// Returns the meshes that lack a tree, for which `hidden` would have to wait.
  std::vector<model::MeshPtr> withoutTree() const;
  /// Tells whether the structure is drawn, apart from sections.
  bool draws(model::NodeId structure) const { return find(structure) != nullptr; }
  /// Tells whether the anchor is visible and not taken away by a section.
  bool shows(const model::Anchor& anchor) const;
  /// Tells whether something that hides is in front of the place; `ray` must go through it. Its own
  /// structure counts if it is nearer by more than 1/200 of its size.
  bool hidden(const model::Anchor& anchor, const model::Ray& ray) const;

 private:
  struct Body {
    const model::Node* node;
    std::vector<model::Plane> planes;
    bool hides;
    bool facesHide;  ///< its cut faces do
    bool mayHide() const { return hides || (facesHide && !planes.empty()); }
  };
  const Body* find(model::NodeId id) const;
  std::optional<SightHit> meet(const Body& body, const model::Ray& ray) const;

  const model::Scene& m_scene;
  model::MeshTrees& m_trees;
  std::vector<Body> m_bodies;  ///< the visible ones
};

}  // namespace sline::render
