// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/mesh_trees.h"

#include <algorithm>
#include <mutex>

#include "model/base/parallel.h"
#include "model/geometry/spatial_order.h"

namespace sline::model {

namespace {

/// Holds one mesh's tree while it is in use.
struct TreeSlot {
  std::mutex making;
  std::weak_ptr<const Bvh> tree;
};

/// Knows the meshes without holding them.
class Register {
 public:
  std::shared_ptr<TreeSlot> slotOf(const MeshPtr& mesh) {
    const std::lock_guard lock(m_mutex);
    const auto known = m_places.find(mesh);
    if (known != m_places.end())
      return known->second;
    std::erase_if(m_places, [](const auto& entry) { return entry.first.expired(); });
    return m_places.emplace(mesh, std::make_shared<TreeSlot>()).first->second;
  }
  std::size_t count() {
    const std::lock_guard lock(m_mutex);
    return std::size_t(std::count_if(m_places.begin(), m_places.end(), [](const auto& entry) {
      return !entry.second->tree.expired();
    }));
  }

 private:
  std::mutex m_mutex;
  std::map<std::weak_ptr<const Mesh>, std::shared_ptr<TreeSlot>, std::owner_less<>> m_places;
};

Register& trees() {
  static Register all;
  return all;
}

}  // namespace

BvhPtr treeOf(const MeshPtr& mesh) {
  const std::shared_ptr<TreeSlot> place = trees().slotOf(mesh);
  const std::lock_guard lock(place->making);
  BvhPtr tree = place->tree.lock();
  if (!tree) {
    isolated([&] { tree = std::make_shared<const Bvh>(mesh, spatialOrder(*mesh)); });
    place->tree = tree;
  }
  return tree;
}

std::size_t treesInMemory() {
  return trees().count();
}

const Bvh& MeshTrees::of(const MeshPtr& mesh) {
  BvhPtr& tree = m_trees[mesh];
  if (!tree)
    tree = treeOf(mesh);
  return *tree;
}

bool MeshTrees::solid(const MeshPtr& mesh) {
  const auto known = m_solid.find(mesh);
  return known != m_solid.end() ? known->second
                                : m_solid.emplace(mesh, isSolid(*mesh)).first->second;
}

void MeshTrees::keepOnly(const std::set<MeshPtr>& meshes) {
  const auto isOther = [&](const auto& entry) { return !meshes.contains(entry.first); };
  std::erase_if(m_trees, isOther);
  std::erase_if(m_surfaces, isOther);
  std::erase_if(m_solid, isOther);
}

}  // namespace sline::model
