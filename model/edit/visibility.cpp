// SPDX-License-Identifier: Apache-2.0
#include "model/edit/visibility.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "model/edit/node_sets.h"

namespace sline::model {

namespace {

Edited editOf(const Scene& before, Scene&& after) {
  const bool changed = !(after == before);
  return {std::move(after), changed};
}

Scene withVisible(const Scene& scene, std::span<const NodeId> ids, bool visible) {
  const NodeSet named = setOf(ids);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (named.contains(node.id.value))
      node.style.visible = visible;
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return after;
}

bool saysHidden(const Scene& scene, NodeId id) {
  const Node* node = scene.find(id);
  return node && !node->style.visible.value_or(true);
}

/// Returns the groups above a node, the nearest first.
std::vector<NodeId> groupsAbove(const Scene& scene, NodeId id) {
  std::vector<NodeId> groups;
  const Node* node = scene.find(id);
  while (node && (node = scene.find(node->parent)) != nullptr)
    groups.push_back(node->id);
  return groups;
}

/// Shows the hidden groups above a node, but not their other contents.
Scene withGroupsOpened(Scene scene, NodeId id) {
  NodeId path = id;
  std::vector<NodeId> others;
  bool hidden = false;
  std::vector<NodeId> groups = groupsAbove(scene, id);
  for (const NodeId group : groups) {
    for (const NodeId child : scene.children(group))
      if (child != path)
        others.push_back(child);
    path = group;
    hidden = hidden || saysHidden(scene, group);
    if (saysHidden(scene, group)) {
      scene = withVisible(scene, others, false);
      others.clear();
    }
  }
  if (hidden)
    scene = withVisible(scene, groups, true);
  return scene;
}

Scene revealed(Scene scene, NodeId id) {
  if (!scene.find(id))
    return scene;
  scene = withGroupsOpened(std::move(scene), id);
  const NodeId itself[] = {id};
  if (saysHidden(scene, id)) {
    scene = withVisible(scene, itself, true);
    if (visibilityOf(scene, id) != Visibility::none)
      return scene;
  }
  if (!scene.find(id)->isGroup())
    return scene;
  // This collects the node and all below it; one pass is enough because a parent stands before its
  // children.
  std::unordered_set<std::uint64_t> meant{id.value};
  std::vector<NodeId> hidden;
  for (const Node& node : scene.nodes()) {
    if (node.id != id && !meant.contains(node.parent.value))
      continue;
    meant.insert(node.id.value);
    if (!node.style.visible.value_or(true))
      hidden.push_back(node.id);
  }
  if (!hidden.empty())
    scene = withVisible(scene, hidden, true);
  return scene;
}

/// Tells whether the node is a group that is hidden by itself but by no group above it.
bool aloneHides(const Scene& scene, NodeId id) {
  const Node* node = scene.find(id);
  if (!node || node->isGroup() || node->style.visible.value_or(true))
    return false;
  const std::vector<NodeId> groups = groupsAbove(scene, id);
  return std::none_of(groups.begin(), groups.end(),
                      [&scene](NodeId group) { return saysHidden(scene, group); });
}

}  // namespace

Visibility visibilityOf(const Scene& scene, NodeId id) {
  const std::vector<NodeId> structures = scene.structuresBelow(id);
  const auto visible = std::count_if(structures.begin(), structures.end(),
                                     [&](NodeId s) { return scene.resolve(s).visible; });
  if (visible == 0)
    return Visibility::none;
  return std::size_t(visible) == structures.size() ? Visibility::all : Visibility::some;
}

Edited withHidden(const Scene& scene, std::span<const NodeId> ids) {
  return editOf(scene, withVisible(scene, ids, false));
}

Edited withShown(const Scene& scene, std::span<const NodeId> ids) {
  // Most nodes are shown at once; the others need their groups above opened, one by one.
  std::vector<NodeId> alone;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(alone),
               [&scene](NodeId id) { return aloneHides(scene, id); });
  Scene after = withVisible(scene, alone, true);
  for (const NodeId id : ids)
    after = revealed(std::move(after), id);
  return editOf(scene, std::move(after));
}

Edited withOthersHidden(const Scene& scene, std::span<const NodeId> ids) {
  const std::vector<NodeId> top = topmost(scene, ids);
  const NodeSet named = setOf(top);
  const NodeSet spared = withAllAbove(scene, named);
  std::vector<NodeId> others;
  for (const Node& node : scene.nodes()) {
    // Below a hidden group no node needs hiding, and all come back with the group.
    const bool besideThem = node.parent == rootId || (spared.contains(node.parent.value) &&
                                                      !named.contains(node.parent.value));
    if (besideThem && !spared.contains(node.id.value))
      others.push_back(node.id);
  }
  if (top.empty())
    return {scene, false};
  return editOf(scene, withVisible(scene, others, false));
}

Edited withOnlyVisible(const Scene& scene, std::span<const NodeId> ids) {
  std::unordered_set<std::uint64_t> shown;  // the structures and all groups above them
  for (const NodeId structure : scene.structuresBelow(ids))
    for (const Node* node = scene.find(structure); node && shown.insert(node->id.value).second;
         node = scene.find(node->parent)) {
    }
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    const bool show = shown.contains(node.id.value);
    if (show && node.style.visible == false)
      node.style.visible = true;
    // Below a hidden group no node needs hiding, and all come back with the group.
    const bool parentShown = node.parent == rootId || shown.contains(node.parent.value);
    if (!show && parentShown)
      node.style.visible = false;
  }
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

}  // namespace sline::model
