// SPDX-License-Identifier: Apache-2.0
#include "model/edit/locks.h"

#include <algorithm>
#include <unordered_map>

#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

void restoreLook(Style& style, const Style& before) {
  const std::optional<bool> visible = style.visible;
  style = before;
  style.visible = visible;
}

/// Answers in the style itself the fields that would now be inherited differently.
void answer(Style& style, const ResolvedStyle& before, const ResolvedStyle& now) {
  forEachLookField([&](const auto& field) {
    if (before.*field.resolved != now.*field.resolved)
      style.*field.own = before.*field.resolved;
  });
}

}  // namespace

NodeSet lockedNodes(const Scene& scene) {
  NodeSet locked;
  for (const Node& node : scene.nodes())
    if (node.locked || locked.contains(node.parent.value))
      locked.insert(node.id.value);
  return locked;
}

std::vector<NodeId> editable(const Scene& scene, std::span<const NodeId> ids) {
  NodeSet known;
  const NodeSet locked = lockedNodes(scene);
  for (const Node& node : scene.nodes())
    if (!locked.contains(node.id.value))
      known.insert(node.id.value);
  std::vector<NodeId> free;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(free),
               [&known](NodeId id) { return known.contains(id.value); });
  return free;
}

Edited withLocksKept(const Scene& before, Scene after) {
  if (const NodeSet locked = lockedNodes(before); !locked.empty()) {
    std::unordered_map<std::uint64_t, const Style*> styles;
    for (const Node& node : before.nodes())
      if (locked.contains(node.id.value))
        styles[node.id.value] = &node.style;
    std::vector<Node> nodes = after.nodes();
    for (Node& node : nodes)
      if (const auto style = styles.find(node.id.value); style != styles.end())
        restoreLook(node.style, *style->second);
    after.setNodes(nodes);
    // Only the topmost locked nodes are changed, because those below inherit from them.
    for (Node& node : nodes)
      if (locked.contains(node.id.value) && !locked.contains(node.parent.value))
        answer(node.style, before.resolve(node.id), after.resolve(node.id));
    after.setNodes(std::move(nodes));
  }
  const bool changed = !(after == before);
  return {std::move(after), changed};
}

Edited withLocked(const Scene& scene, std::span<const NodeId> ids, bool locked) {
  const NodeSet named = setOf(ids);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (named.contains(node.id.value))
      node.locked = locked;
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

}  // namespace sline::model
