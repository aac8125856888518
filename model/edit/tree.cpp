// SPDX-License-Identifier: Apache-2.0
#include "model/edit/tree.h"

#include <algorithm>
#include <unordered_set>

namespace sline::model {

namespace {

using IdSet = std::unordered_set<std::uint64_t>;

/// The ids of the nodes and of everything below them.
IdSet subtrees(const Scene& scene, std::span<const NodeId> ids) {
  IdSet wanted;
  for (const NodeId id : ids)
    wanted.insert(id.value);
  IdSet inside;
  for (const Node& node : scene.nodes())
    if (wanted.contains(node.id.value) || inside.contains(node.parent.value))
      inside.insert(node.id.value);
  return inside;
}

Edited withNodesReplaced(const Scene& scene, std::vector<Node> nodes) {
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

bool pointsAt(const Annotation& annotation, const IdSet& nodes) {
  const auto onOne = [&nodes](const Anchor& anchor) {
    const auto* point = std::get_if<SurfacePoint>(&anchor);
    return point && nodes.contains(point->structure.value);
  };
  return std::any_of(annotation.anchors.begin(), annotation.anchors.end(), onOne);
}

/// Takes what is said of the nodes out of sections, annotations and saved views.
void forget(Scene& scene, const IdSet& gone) {
  const auto cutsNothing = [&gone](const Section& section) {
    return section.scope != rootId && gone.contains(section.scope.value);
  };
  std::vector<Section> sections = scene.sections();
  std::erase_if(sections, cutsNothing);
  scene.setSections(std::move(sections));

  std::vector<Annotation> annotations;
  IdSet unsaid;
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
      std::erase_if(*view.looks,
                    [&gone](const Look& look) { return gone.contains(look.node.value); });
    if (view.annotations)
      std::erase_if(*view.annotations,
                    [&unsaid](AnnotationId id) { return unsaid.contains(id.value); });
  }
  scene.setViews(std::move(views));
}

}  // namespace

Edited renamed(const Scene& scene, NodeId id, const std::string& name) {
  if (name.empty())
    return {scene, false};
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (node.id == id)
      node.name = name;
  return withNodesReplaced(scene, std::move(nodes));
}

Edited removed(const Scene& scene, std::span<const NodeId> ids) {
  const IdSet gone = subtrees(scene, ids);
  std::vector<Node> nodes = scene.nodes();
  std::erase_if(nodes, [&gone](const Node& node) { return gone.contains(node.id.value); });
  Edited edited = withNodesReplaced(scene, std::move(nodes));
  if (edited.changed)
    forget(edited.scene, gone);
  return edited;
}

Edited moved(const Scene& scene, std::span<const NodeId> ids, NodeId group) {
  const IdSet moving = subtrees(scene, ids);
  const Node* target = scene.find(group);
  if (moving.contains(group.value) || (group != rootId && (!target || !target->isGroup())))
    return {scene, false};

  std::vector<Node> staying;
  std::vector<Node> arriving;
  IdSet inGroup{group.value};
  std::size_t end = 0;  // behind the group's last descendant among those that stay
  for (const Node& node : scene.nodes()) {
    if (moving.contains(node.id.value)) {
      arriving.push_back(node);
      // What moves together with its parent stays below it.
      if (!moving.contains(node.parent.value))
        arriving.back().parent = group;
      continue;
    }
    staying.push_back(node);
    if (node.id == group || inGroup.contains(node.parent.value)) {
      inGroup.insert(node.id.value);
      end = staying.size();
    }
  }
  staying.insert(staying.begin() + std::ptrdiff_t(end), arriving.begin(), arriving.end());
  return withNodesReplaced(scene, std::move(staying));
}

}  // namespace sline::model
