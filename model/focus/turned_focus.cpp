// SPDX-License-Identifier: Apache-2.0
#include "model/focus/turned_focus.h"

#include <map>
#include <optional>
#include <set>
#include <unordered_set>

#include "model/edit/node_sets.h"
#include "model/focus/context.h"
#include "model/focus/nearness.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

/// Returns the styles that the focus gives where it is seen from those cameras.
std::map<NodeId, Style> stylesFrom(const Scene& scene, std::span<const Camera> cameras) {
  std::map<NodeId, Style> styles;
  const Focus& focus = scene.focus();
  if (const std::optional<NearFocus> near = nearFocusOf(scene)) {
    std::set<NodeId> before;
    MeshTrees trees;
    for (const Camera& camera : cameras)
      before.merge(structuresBefore(scene, *near, camera, trees));
    const Scene focused = withNearFocus(scene, *near, before).scene;
    for (const Look& look : focused.focus().given)
      styles[look.node] = look.style;
    return styles;
  }
  FormIndex forms;
  const auto analysis = analysed(scene, {.targets = focus.targets, .turn = cameras}, forms);
  if (!analysis)
    return styles;
  for (Relation relation : analysis->relations) {
    if (const auto wish = focus.wishes.roles.find(relation.structure);
        wish != focus.wishes.roles.end())
      relation.role = wish->second;
    styles[relation.structure] = contextStyle(relation, focus.amount);
  }
  return styles;
}

}  // namespace

Scene withFocusSeenFrom(const Scene& scene, std::span<const Camera> cameras) {
  const Focus& focus = scene.focus();
  if (focus.targets.empty() && !focus.nearness)
    return scene;
  const std::map<NodeId, Style> styles = stylesFrom(scene, cameras);
  const std::unordered_set<std::uint64_t> hers = setOf(setByHand(scene));
  std::map<NodeId, const Style*> given;
  for (const Look& look : focus.given)
    given[look.node] = &look.style;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    const auto was = given.find(node.id);
    const auto is = styles.find(node.id);
    // What looks the same from all sides keeps what a drawing style has made of it since.
    if (was == given.end() || is == styles.end() || *was->second == is->second ||
        hers.contains(node.id.value) || scene.isLocked(node.id) || !scene.resolve(node.id).visible)
      continue;
    patch(node.style, is->second);
  }
  Scene turned = scene;
  turned.setNodes(std::move(nodes));
  return turned;
}

}  // namespace sline::model
