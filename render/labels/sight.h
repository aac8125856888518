// SPDX-License-Identifier: Apache-2.0
// What is seen along a line of sight, and what is hidden. What is transparent hides nothing: a
// structure without a fill or shading, a tinted or veiled one, and one that is more clear than not.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "model/geometry/bvh.h"
#include "model/scene/scene.h"

namespace sline::render {

/// Each mesh's tree, made when a line first comes near and kept from picture to picture.
class SightTrees {
 public:
  const model::Bvh& treeOf(const model::MeshPtr& mesh);
  bool has(const model::MeshPtr& mesh) const { return m_trees.contains(mesh); }
  /// Forgets meshes that the scene no longer has.
  void keepThoseOf(const model::Scene& scene);

 private:
  std::map<model::MeshPtr, std::unique_ptr<model::Bvh>> m_trees;
};

/// One scene as it is drawn. The scene and the trees must outlive this.
class Sights {
 public:
  Sights(const model::Scene& scene, SightTrees& trees);

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
  SightTrees& m_trees;
  std::vector<Body> m_bodies;  ///< the visible ones
};

}  // namespace sline::render
