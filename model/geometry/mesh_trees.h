// SPDX-License-Identifier: Apache-2.0
// Bounding-volume trees by mesh: one for each mesh, whoever asks.
#pragma once

#include <map>
#include <memory>
#include <set>

#include "model/geometry/bvh.h"

namespace sline::model {

using BvhPtr = std::shared_ptr<const Bvh>;

/// Returns the mesh's tree, which is made when it is first asked for and goes when nobody holds it
/// any more: all who hold it at one time hold the same. May be called from any thread; who asks
/// while another makes it waits.
BvhPtr treeOf(const MeshPtr& mesh);

/// Returns how many trees there are in memory, of all meshes.
std::size_t treesInMemory();

/// The trees that somebody uses again and again, held until told otherwise. For one thread.
class MeshTrees {
 public:
  const Bvh& of(const MeshPtr& mesh);
  bool has(const MeshPtr& mesh) const { return m_trees.contains(mesh); }
  /// Lets go of the trees of all other meshes.
  void keepOnly(const std::set<MeshPtr>& meshes);

 private:
  std::map<MeshPtr, BvhPtr> m_trees;
};

}  // namespace sline::model
