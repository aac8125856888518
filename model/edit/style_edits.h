// SPDX-License-Identifier: Apache-2.0
// Shares code between the edits of looks; for the use of this room only.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/edit/locks.h"

namespace sline::model {

/// Returns the scene with these nodes in place of its own, except for changes that locks prevent.
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
