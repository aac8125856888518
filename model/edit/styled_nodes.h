// SPDX-License-Identifier: Apache-2.0
// What edits of looks have in common; for the rooms' own use.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/edit/locks.h"

namespace sline::model {

/// The scene with these nodes in place of its own, but for what locks keep from them.
inline Edited withNodesRestyled(const Scene& scene, std::vector<Node> nodes) {
  if (nodes == scene.nodes())
    return {scene, false};
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return withLocksKept(scene, std::move(after));
}

/// Calls change(style, named) for the named nodes and for all below them.
template <class Change>
Edited withStyles(const Scene& scene, std::span<const NodeId> ids, const Change& change) {
  const NodeSet named = setOf(ids);
  const NodeSet meant = withAllBelow(scene, named);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (meant.contains(node.id.value))
      change(node.style, named.contains(node.id.value));
  return withNodesRestyled(scene, std::move(nodes));
}

}  // namespace sline::model
