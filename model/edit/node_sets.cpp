// SPDX-License-Identifier: Apache-2.0
#include "model/edit/node_sets.h"

namespace sline::model {

NodeSet setOf(std::span<const NodeId> ids) {
  NodeSet set;
  for (const NodeId id : ids)
    set.insert(id.value);
  return set;
}

// One pass each is enough because a parent stands before its children.

NodeSet withAllBelow(const Scene& scene, NodeSet ids) {
  for (const Node& node : scene.nodes())
    if (ids.contains(node.parent.value))
      ids.insert(node.id.value);
  return ids;
}

NodeSet withAllAbove(const Scene& scene, NodeSet ids) {
  const std::vector<Node>& nodes = scene.nodes();
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (ids.contains(nodes[i].id.value) && nodes[i].parent != rootId)
      ids.insert(nodes[i].parent.value);
  return ids;
}

std::vector<NodeId> topmost(const Scene& scene, std::span<const NodeId> ids) {
  const NodeSet named = setOf(ids);
  NodeSet inside;
  std::vector<NodeId> top;
  for (const Node& node : scene.nodes()) {
    if (inside.contains(node.parent.value)) {
      inside.insert(node.id.value);
    } else if (named.contains(node.id.value)) {
      inside.insert(node.id.value);
      top.push_back(node.id);
    }
  }
  return top;
}

}  // namespace sline::model
