// SPDX-License-Identifier: Apache-2.0
#include "model/edit/tree.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "model/edit/locks.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

Edited withNodesReplaced(const Scene& scene, std::vector<Node> nodes) {
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

/// Returns the scene with these nodes while locked nodes keep their looks, for edits after which
/// they might inherit differently.
Edited ofSameLook(const Scene& scene, std::vector<Node> nodes) {
  if (nodes == scene.nodes())
    return {scene, false};
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return withLocksKept(scene, std::move(after));
}

bool pointsAt(const Annotation& annotation, const NodeSet& nodes) {
  const auto onOne = [&nodes](const Anchor& anchor) {
    const auto* point = std::get_if<SurfacePoint>(&anchor);
    return point && nodes.contains(point->structure.value);
  };
  return std::any_of(annotation.anchors.begin(), annotation.anchors.end(), onOne);
}

/// Removes the nodes from what Γ follows; a map that has lost all its targets goes too.
void forget(Style& style, const NodeSet& gone) {
  if (!style.gammaMap)
    return;
  const auto isGone = [&gone](NodeId id) { return gone.contains(id.value); };
  if (std::erase_if(style.gammaMap->targets, isGone) > 0 && style.gammaMap->targets.empty() &&
      !style.gammaMap->place)
    style.gammaMap.reset();
}

void forgetIn(std::vector<Look>& looks, const NodeSet& gone) {
  std::erase_if(looks, [&gone](const Look& look) { return gone.contains(look.node.value); });
  for (Look& look : looks)
    forget(look.style, gone);
}

void forget(Focus& focus, const NodeSet& gone) {
  const auto isGone = [&gone](NodeId id) { return gone.contains(id.value); };
  std::erase_if(focus.targets, isGone);
  std::erase_if(focus.wishes.roles, [&](const auto& wish) { return isGone(wish.first); });
  forgetIn(focus.given, gone);
}

/// Removes the nodes from sections, annotations, saved views and what Γ follows.
void forget(Scene& scene, const NodeSet& gone) {
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    forget(node.style, gone);
  scene.setNodes(std::move(nodes));

  const auto cutsNothing = [&gone](const Section& section) {
    return section.scope != rootId && gone.contains(section.scope.value);
  };
  std::vector<Section> sections = scene.sections();
  std::erase_if(sections, cutsNothing);
  scene.setSections(std::move(sections));

  std::vector<Annotation> annotations;
  NodeSet unsaid;
  for (const Annotation& annotation : scene.annotations())
    if (pointsAt(annotation, gone))
      unsaid.insert(annotation.id.value);
    else
      annotations.push_back(annotation);
  scene.setAnnotations(std::move(annotations));

  std::vector<View> views = scene.views();
  for (View& view : views) {
    if (view.sections)
      std::erase_if(*view.sections, cutsNothing);
    if (view.looks)
      forgetIn(*view.looks, gone);
    if (view.annotations)
      std::erase_if(*view.annotations,
                    [&unsaid](AnnotationId id) { return unsaid.contains(id.value); });
    if (view.focus)
      forget(*view.focus, gone);
  }
  scene.setViews(std::move(views));
  Focus focus = scene.focus();
  forget(focus, gone);
  scene.setFocus(std::move(focus));
}

/// Returns the nodes in tree order below their new parents, after some of them have moved.
std::vector<Node> inTreeOrder(const std::vector<Node>& nodes,
                              const std::unordered_map<std::uint64_t, std::vector<NodeId>>& below) {
  std::unordered_map<std::uint64_t, const Node*> byId;
  for (const Node& node : nodes)
    byId[node.id.value] = &node;
  std::vector<Node> ordered;
  ordered.reserve(nodes.size());
  std::vector<NodeId> waiting{rootId};  // the last entry is the next to visit
  while (!waiting.empty()) {
    const NodeId id = waiting.back();
    waiting.pop_back();
    if (id != rootId)
      ordered.push_back(*byId.at(id.value));
    if (const auto children = below.find(id.value); children != below.end())
      waiting.insert(waiting.end(), children->second.rbegin(), children->second.rend());
  }
  return ordered;
}

/// Returns the children of each group, in their order.
std::unordered_map<std::uint64_t, std::vector<NodeId>> childrenOf(const std::vector<Node>& nodes) {
  std::unordered_map<std::uint64_t, std::vector<NodeId>> children;
  for (const Node& node : nodes)
    children[node.parent.value].push_back(node.id);
  return children;
}

/// Returns the style that a node needs of its own to look the same without the group above it.
Style handedDown(const Style& own, const Style& group) {
  const std::optional<bool> hidden = group.visible == false ? group.visible : own.visible;
  Style style = group;
  patch(style, own);
  style.visible = hidden;
  return style;
}

/// Holds what a structure is called.
struct Called {
  std::string name;
  std::map<std::string, std::string> inOthers;  ///< by language
};

/// Calls a label after the new name where it was called after the old one.
void follow(Annotation& annotation, const Called& old, const Called& now) {
  const bool own = annotation.text == old.name;
  std::map<std::string, std::string> texts;
  for (const auto& [tag, text] : annotation.texts) {
    const auto was = old.inOthers.find(tag);
    if (was == old.inOthers.end() || was->second != text)
      texts[tag] = text;
    else if (const auto is = now.inOthers.find(tag); is != now.inOthers.end())
      texts[tag] = is->second;
  }
  if (own) {
    annotation.text = now.name;
    texts.insert(now.inOthers.begin(), now.inOthers.end());
  }
  annotation.texts = std::move(texts);
}

}  // namespace

Edited renamed(const Scene& scene, NodeId id, const std::string& name, const NamesOf& namesOf) {
  if (name.empty() || scene.isLocked(id))
    return {scene, false};
  std::vector<Node> nodes = scene.nodes();
  Called old;
  for (Node& node : nodes)
    if (node.id == id) {
      old.name = std::exchange(node.name, name);
      // What was found of the name before says nothing of the new one.
      if (node.name != old.name)
        node.provenance.nameEvidence = Evidence::known;
    }
  Edited edited = withNodesReplaced(scene, std::move(nodes));
  if (!edited.changed)
    return edited;
  Called now{.name = name, .inOthers = {}};
  if (namesOf) {
    old.inOthers = namesOf(old.name);
    now.inOthers = namesOf(now.name);
  }
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    if (pointsAt(annotation, {id.value}))
      follow(annotation, old, now);
  edited.scene.setAnnotations(std::move(annotations));
  return edited;
}

Edited removed(const Scene& scene, std::span<const NodeId> ids) {
  NodeSet gone = withAllBelow(scene, setOf(ids));
  for (const std::uint64_t spared : withAllAbove(scene, lockedNodes(scene)))
    gone.erase(spared);
  std::vector<Node> nodes = scene.nodes();
  std::erase_if(nodes, [&gone](const Node& node) { return gone.contains(node.id.value); });
  Edited edited = withNodesReplaced(scene, std::move(nodes));
  if (edited.changed)
    forget(edited.scene, gone);
  return edited;
}

Edited moved(const Scene& scene, std::span<const NodeId> ids, NodeId group, NodeId before) {
  const Node* target = scene.find(group);
  if (group != rootId && (!target || !target->isGroup() || scene.isLocked(group)))
    return {scene, false};
  const std::vector<NodeId> moving = topmost(scene, editable(scene, ids));
  const NodeSet set = setOf(moving);
  if (moving.empty() || withAllBelow(scene, set).contains(group.value))
    return {scene, false};

  auto children = childrenOf(scene.nodes());
  std::vector<NodeId> staying;
  std::size_t place = 0;
  bool placed = false;
  for (const NodeId child : children[group.value]) {
    // Where `before` itself moves, the position is that of the child that follows it.
    placed = placed || child == before;
    if (set.contains(child.value))
      continue;
    if (!placed)
      ++place;
    staying.push_back(child);
  }
  staying.insert(staying.begin() + std::ptrdiff_t(place), moving.begin(), moving.end());
  for (auto& [parent, there] : children)
    std::erase_if(there, [&set](NodeId id) { return set.contains(id.value); });
  children[group.value] = std::move(staying);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (set.contains(node.id.value))
      node.parent = group;
  return ofSameLook(scene, inTreeOrder(nodes, children));
}

Grouped withGroup(const Scene& scene, const std::string& name, NodeId parent) {
  const Node* above = scene.find(parent);
  if (name.empty() || (parent != rootId && (!above || !above->isGroup() || scene.isLocked(parent))))
    return {{scene, false}, rootId};
  Scene after = scene;
  const NodeId group = after.append({.parent = parent, .name = name});
  return {{std::move(after), true}, group};
}

Grouped grouped(const Scene& scene, std::span<const NodeId> ids, const std::string& name) {
  const std::vector<NodeId> members = topmost(scene, editable(scene, ids));
  if (members.empty())
    return {{scene, false}, rootId};
  Grouped made = withGroup(scene, name, scene.find(members.front())->parent);
  if (!made.edited.changed)
    return made;
  const NodeId group[] = {made.group};
  const NodeId parent = scene.find(members.front())->parent;
  const Scene placed = moved(made.edited.scene, group, parent, members.front()).scene;
  made.edited = {moved(placed, members, made.group).scene, true};
  return made;
}

Edited ungrouped(const Scene& scene, std::span<const NodeId> ids) {
  const NodeSet stuck = lockedNodes(scene);
  auto children = childrenOf(scene.nodes());
  NodeSet gone;
  for (const NodeId id : editable(scene, ids)) {
    const auto& inside = children[id.value];
    if (scene.find(id)->isGroup() && std::none_of(inside.begin(), inside.end(), [&](NodeId child) {
          return stuck.contains(child.value);
        }))
      gone.insert(id.value);
  }
  if (gone.empty())
    return {scene, false};
  // Tree order stays valid: the children of a group follow right after it.
  std::unordered_map<std::uint64_t, Node> dissolved;
  std::vector<Node> nodes;
  for (Node node : scene.nodes()) {
    if (const auto group = dissolved.find(node.parent.value); group != dissolved.end()) {
      node.parent = group->second.parent;
      node.style = handedDown(node.style, group->second.style);
    }
    if (gone.contains(node.id.value))
      dissolved[node.id.value] = std::move(node);
    else
      nodes.push_back(std::move(node));
  }
  Edited edited = withNodesReplaced(scene, std::move(nodes));
  forget(edited.scene, gone);
  return edited;
}

}  // namespace sline::model
