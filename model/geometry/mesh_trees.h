// SPDX-License-Identifier: Apache-2.0
// Keeps bounding-volume trees by mesh, one shared tree for each mesh.
#pragma once

#include <map>
#include <memory>
#include <set>

#include "model/geometry/bvh.h"
#include "model/geometry/surface.h"

namespace sline::model {

using BvhPtr = std::shared_ptr<const Bvh>;

/// Returns the mesh's tree, which is made on the first request and freed when the last holder lets
/// go of it; all holders at one time share it. May be called from any thread; a caller waits while
/// another one makes the tree.
BvhPtr treeOf(const MeshPtr& mesh);

/// Returns how many trees of all meshes there are in memory.
std::size_t treesInMemory();

/// Holds the trees that its owner uses again and again until told otherwise, and surfaces that were
/// made of their meshes. For one thread.
class MeshTrees {
 public:
  const Bvh& of(const MeshPtr& mesh);
  /// Returns the place for the mesh's surface, which is null until a caller has made it.
  SurfacePtr& surfaceOf(const MeshPtr& mesh) { return m_surfaces[mesh]; }
  /// Tells whether cutting the mesh makes faces (`Surface::solid`).
  bool solid(const MeshPtr& mesh);
  bool has(const MeshPtr& mesh) const { return m_trees.contains(mesh); }
  /// Forgets all other meshes.
  void keepOnly(const std::set<MeshPtr>& meshes);

 private:
  std::map<MeshPtr, BvhPtr> m_trees;
  std::map<MeshPtr, SurfacePtr> m_surfaces;
  std::map<MeshPtr, bool> m_solid;
};

}  // namespace sline::model
