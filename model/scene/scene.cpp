// SPDX-License-Identifier: Apache-2.0
#include "model/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>

#include "model/base/letters.h"
#include "model/scene/scene_limits.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

using IdSet = std::unordered_set<std::uint64_t>;

/// Calls visit(index, node) for the nodes and everything below them, in tree order; the root is
/// above every node. One pass is enough because a parent stands before its children.
template <class Visit>
void forEachBelow(const std::vector<Node>& nodes, std::span<const NodeId> ids, const Visit& visit) {
  IdSet inside;
  for (const NodeId id : ids)
    inside.insert(id.value);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (inside.contains(node.parent.value))
      inside.insert(node.id.value);
    if (inside.contains(node.id.value))
      visit(i, node);
  }
}

[[maybe_unused]] bool inTreeOrder(const std::vector<Node>& nodes) {
  IdSet seen{rootId.value};
  return std::all_of(nodes.begin(), nodes.end(), [&seen](const Node& node) {
    return seen.contains(node.parent.value) && seen.insert(node.id.value).second;
  });
}

/// Returns an id that none of the items has: the next one or, where that could not be written any
/// more, the smallest that is free.
template <class Item>
std::uint64_t freshId(std::uint64_t& last, const std::vector<Item>& items) {
  if (last < largestId)
    return ++last;
  IdSet taken;
  for (const Item& item : items)
    taken.insert(item.id.value);
  std::uint64_t id = 1;
  while (taken.contains(id))
    ++id;
  return id;
}

}  // namespace

const std::string& titleIn(const View& view, const std::string& language) {
  const std::string& title = view.words.title.in(language);
  return title.empty() ? view.name : title;
}

const Node* Scene::find(NodeId id) const {
  const auto place = placeBefore(id.value);
  return place == m_places.end() || place->id != id.value ? nullptr : &m_nodes[place->index];
}

std::vector<Scene::NodeIndex>::const_iterator Scene::placeBefore(std::uint64_t id) const {
  return std::lower_bound(m_places.begin(), m_places.end(), NodeIndex{id, 0});
}

void Scene::index() {
  m_places.clear();
  m_places.reserve(m_nodes.size());
  for (const Node& node : m_nodes)
    m_places.push_back({node.id.value, m_places.size()});
  std::sort(m_places.begin(), m_places.end());
}

std::vector<NodeId> Scene::children(NodeId parent) const {
  std::vector<NodeId> ids;
  for (const Node& node : m_nodes)
    if (node.parent == parent)
      ids.push_back(node.id);
  return ids;
}

std::vector<NodeId> Scene::structuresBelow(std::span<const NodeId> ids) const {
  std::vector<NodeId> structures;
  forEachBelow(m_nodes, ids, [&structures](std::size_t, const Node& node) {
    if (!node.isGroup())
      structures.push_back(node.id);
  });
  return structures;
}

std::vector<NodeId> Scene::structuresBelow(NodeId id) const {
  return structuresBelow(std::span(&id, 1));
}

bool Scene::isBelow(NodeId id, NodeId ancestor) const {
  for (;;) {
    if (id == ancestor)
      return true;
    const Node* node = find(id);
    if (!node)
      return false;
    id = node->parent;
  }
}

std::string Scene::groupPath(NodeId id) const {
  std::string path;
  const Node* node = find(id);
  while (node && (node = find(node->parent)) != nullptr)
    path.insert(0, path.empty() ? node->name : node->name + " / ");
  return path;
}

ResolvedStyle Scene::resolve(NodeId id) const {
  Style style;
  ResolvedStyle resolved;
  for (const Node* node = find(id); node; node = find(node->parent)) {
    inherit(style, node->style);
    resolved.visible = resolved.visible && node->style.visible.value_or(true);
  }
  answer(resolved, style);
  return resolved;
}

bool Scene::isLocked(NodeId id) const {
  for (const Node* node = find(id); node; node = find(node->parent))
    if (node->locked)
      return true;
  return false;
}

std::vector<NodeId> Scene::named(std::string_view name) const {
  const std::string wanted = normalisedName(name);
  std::vector<NodeId> ids;
  for (const Node& node : m_nodes)
    if (normalisedName(node.name) == wanted)
      ids.push_back(node.id);
  return ids;
}

Box Scene::visibleBounds(NodeId id) const {
  Box bounds;
  forEachBelow(m_nodes, std::span(&id, 1), [&](std::size_t, const Node& node) {
    if (!node.isGroup() && !node.mesh->bounds().empty() && resolve(node.id).visible)
      bounds.add(node.mesh->bounds());
  });
  return bounds;
}

std::vector<Section> Scene::sectionsOf(NodeId id) const {
  std::vector<Section> cutting;
  for (const Section& section : m_sections)
    if (section.enabled && isBelow(id, section.scope))
      cutting.push_back(section);
  return cutting;
}

NodeId Scene::append(Node node) {
  assert(node.parent == rootId || find(node.parent));
  // Building a tree appends mostly below the last node.
  std::size_t position = m_nodes.size();
  if (node.parent != rootId && !isBelow(m_nodes.back().id, node.parent))
    forEachBelow(m_nodes, std::span(&node.parent, 1),
                 [&position](std::size_t index, const Node&) { position = index + 1; });
  const bool highest = m_lastId < largestId;
  node.id = NodeId{freshId(m_lastId, m_nodes)};
  const NodeId id = node.id;
  const bool last = highest && position == m_nodes.size();
  m_nodes.insert(m_nodes.begin() + std::ptrdiff_t(position), std::move(node));
  if (last)
    m_places.push_back({id.value, position});  // no id is higher than this
  else
    index();
  return id;
}

void Scene::setNodes(std::vector<Node> nodes) {
  assert(inTreeOrder(nodes));
  m_nodes = std::move(nodes);
  index();
  for (const Node& node : m_nodes)
    m_lastId = std::max(m_lastId, node.id.value);
}

SectionId Scene::appendSection(Section section) {
  assert(!planeFault(section.plane));
  section.id = SectionId{freshId(m_lastSectionId, m_sections)};
  m_sections.push_back(std::move(section));
  return m_sections.back().id;
}

void Scene::setSections(std::vector<Section> sections) {
  m_sections = std::move(sections);
  [[maybe_unused]] IdSet seen;
  for (const Section& section : m_sections) {
    assert(!planeFault(section.plane) && seen.insert(section.id.value).second);
    m_lastSectionId = std::max(m_lastSectionId, section.id.value);
  }
}

std::optional<glm::vec3> Scene::placeOf(const Anchor& anchor) const {
  if (const auto* place = std::get_if<glm::vec3>(&anchor))
    return *place;
  const SurfacePoint& point = std::get<SurfacePoint>(anchor);
  const Node* node = find(point.structure);
  if (!node || node->isGroup() || point.triangle >= node->mesh->triangleCount())
    return std::nullopt;
  return placeOn(*node->mesh, point);
}

AnnotationId Scene::appendAnnotation(Annotation annotation) {
  assert(!annotationFault(annotation));
  annotation.id = AnnotationId{freshId(m_lastAnnotationId, m_annotations)};
  m_annotations.push_back(std::move(annotation));
  return m_annotations.back().id;
}

void Scene::setScans(std::vector<Scan> scans) {
  assert(std::all_of(scans.begin(), scans.end(),
                     [](const Scan& scan) { return scanFault(scan).empty(); }));
  m_scans = std::move(scans);
}

void Scene::setAnnotations(std::vector<Annotation> annotations) {
  m_annotations = std::move(annotations);
  [[maybe_unused]] IdSet seen;
  for (const Annotation& annotation : m_annotations) {
    assert(!annotationFault(annotation) && seen.insert(annotation.id.value).second);
    m_lastAnnotationId = std::max(m_lastAnnotationId, annotation.id.value);
  }
}

std::set<MeshPtr> meshesOf(const Scene& scene) {
  std::set<MeshPtr> meshes;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      meshes.insert(node.mesh);
  return meshes;
}

std::string normalisedName(std::string_view name) {
  std::string normal;
  for (const char c : name) {
    const bool blank = c == ' ' || c == '_' || c == '-' || c == '\t';
    if (!blank)
      normal += lowerCase(c);
    else if (!normal.empty() && normal.back() != ' ')
      normal += ' ';
  }
  if (!normal.empty() && normal.back() == ' ')
    normal.pop_back();
  return normal;
}

}  // namespace sline::model
