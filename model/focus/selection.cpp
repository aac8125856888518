// SPDX-License-Identifier: Apache-2.0
#include "model/focus/selection.h"

#include <set>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/kin_names.h"
#include "model/edit/node_sets.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

/// Returns those structures of the scene that the function chooses, in tree order.
template <class Chooses>
std::vector<NodeId> chosen(const Scene& scene, const Chooses& chooses) {
  std::vector<NodeId> ids;
  for (const VisibleStructure& structure : visibleStructures(scene))
    if (!scene.isLocked(structure.node->id) && chooses(*structure.node))
      ids.push_back(structure.node->id);
  return ids;
}

std::vector<NodeId> inTreeOrder(const Scene& scene, const NodeSet& selected,
                                const std::vector<NodeId>& more) {
  NodeSet all = setOf(more);
  all.insert(selected.begin(), selected.end());
  std::vector<NodeId> ids;
  for (const Node& node : scene.nodes())
    if (!node.isGroup() && all.contains(node.id.value))
      ids.push_back(node.id);
  return ids;
}

NodeSet selectedOf(const Scene& scene, std::span<const NodeId> selection) {
  return withAllBelow(scene, setOf(selection));
}

}  // namespace

std::vector<NodeId> selectable(const Scene& scene) {
  return chosen(scene, [](const Node&) { return true; });
}

std::vector<NodeId> withoutSelected(const Scene& scene, std::span<const NodeId> selection) {
  const NodeSet selected = selectedOf(scene, selection);
  return chosen(scene, [&](const Node& node) { return !selected.contains(node.id.value); });
}

std::vector<NodeId> ofSameKind(const Scene& scene, std::span<const NodeId> selection) {
  const NodeSet selected = selectedOf(scene, selection);
  const AnatomyTable anatomy;
  std::set<std::string> families;
  std::set<std::size_t> systems;
  for (const Node& node : scene.nodes()) {
    if (node.isGroup() || !selected.contains(node.id.value))
      continue;
    families.insert(kinName(node.name).family);
    if (const auto match = anatomy.match(node.name))
      systems.insert(match->system);
  }
  families.erase(std::string());
  const std::vector<NodeId> before = inTreeOrder(scene, selected, {});
  std::vector<NodeId> kind = inTreeOrder(scene, selected, chosen(scene, [&](const Node& node) {
                                           return families.contains(kinName(node.name).family);
                                         }));
  if (kind != before)
    return kind;
  return inTreeOrder(scene, selected, chosen(scene, [&](const Node& node) {
                       const auto match = anatomy.match(node.name);
                       return match && systems.contains(match->system);
                     }));
}

std::vector<NodeId> onOtherSide(const Scene& scene, std::span<const NodeId> selection) {
  const NodeSet selected = selectedOf(scene, selection);
  std::set<std::pair<Side, std::string>> wanted;
  for (const Node& node : scene.nodes()) {
    if (node.isGroup() || !selected.contains(node.id.value))
      continue;
    if (const KinName name = kinName(node.name); name.side != Side::none)
      wanted.emplace(name.side == Side::left ? Side::right : Side::left, name.pair);
  }
  return chosen(scene, [&](const Node& node) {
    const KinName name = kinName(node.name);
    return wanted.contains({name.side, name.pair});
  });
}

}  // namespace sline::model
