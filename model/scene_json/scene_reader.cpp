// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/scene_reader.h"

#include <set>
#include <string>
#include <utility>

#include "model/scene_json/atoms_json.h"
#include "model/scene_json/provenance_json.h"
#include "model/scene_json/style_json.h"

namespace sline::model {

namespace {

constexpr std::size_t mostNodes = 100'000;
constexpr std::size_t mostViews = 10'000;
constexpr std::size_t deepestNode = 256;

KeyLight keyLightFrom(const JsonValue& value) {
  JsonObject object(value);
  KeyLight light;
  light.towards = object.need("towards").point();
  if (const auto shades = object.take("shades"))
    light.shades = shades->flag();
  light.unread = object.unread();
  if (const auto fault = lightFault(light))
    value.fail(*fault);
  return light;
}

/// Checks the tree order: each node is new, and lies below the node before it or one of that node's
/// groups.
class TreeOrderCheck {
 public:
  void add(const Node& node, const JsonValue& value) {
    while (!m_open.empty() && m_open.back() != node.parent)
      m_open.pop_back();
    if (m_open.empty())
      value.fail("its parent is not among the groups that are open before it");
    if (!m_ids.insert(node.id).second)
      value.fail("another node has the same id");
    if (node.isGroup())
      m_open.push_back(node.id);
    if (m_open.size() > deepestNode + 1)  // the root is open too
      value.fail("groups lie more than " + std::to_string(deepestNode) + " deep in each other");
  }

 private:
  std::set<NodeId> m_ids{rootId};
  std::vector<NodeId> m_open{rootId};
};

}  // namespace

MeshPtr SceneJsonReader::mesh(JsonObject& object) const {
  const JsonValue file = object.need("file");
  const auto found = m_parts.meshes.find(file.text());
  if (found == m_parts.meshes.end()) {
    file.fail("the file holds no such mesh");
    return nullptr;
  }
  const MeshPtr& mesh = found->second;
  const auto promised = [&object](std::string_view key, std::size_t count) {
    const auto value = object.take(key);
    if (value && value->whole(0, largestId) != std::int64_t(count))
      value->fail("the mesh has " + std::to_string(count));
  };
  promised("vertices", mesh->vertexCount());
  promised("triangles", mesh->triangleCount());
  return mesh;
}

PaintPtr SceneJsonReader::paint(JsonObject& object, const Mesh& mesh) const {
  const JsonValue file = object.need("file");
  const auto found = m_parts.paints.find(file.text());
  if (found == m_parts.paints.end()) {
    file.fail("the file holds no such paint");
    return nullptr;
  }
  if (found->second->size() != mesh.vertexCount()) {
    file.fail("it has " + std::to_string(found->second->size()) + " values, and the mesh " +
              std::to_string(mesh.vertexCount()) + " vertices");
    return nullptr;
  }
  return found->second;
}

Node SceneJsonReader::node(const JsonValue& value) const {
  JsonObject object(value);
  Node node;
  node.id.value = idOf(object.need("id"));
  if (const auto parent = object.take("parent"))
    node.parent.value = idOf(*parent);
  node.name = object.need("name").text();
  if (const auto reference = object.take("mesh")) {
    JsonObject inner(*reference);
    node.mesh = mesh(inner);
    object.giveBack("mesh", inner.rest());
  }
  if (const auto painted = object.take("paint")) {
    JsonObject inner(*painted);
    if (node.mesh)
      node.paint = paint(inner, *node.mesh);
    else
      painted->fail("a node without a mesh has nothing to paint on");
    object.giveBack("paint", inner.rest());
  }
  if (const auto own = object.take("style")) {
    JsonObject inner(*own);
    node.style = styleFrom(inner, m_newer);
    object.giveBack("style", inner.rest());
  }
  if (const auto locked = object.take("locked"))
    node.locked = locked->flag();
  if (const auto origin = object.take("provenance")) {
    JsonObject inner(*origin);
    node.provenance = provenanceFrom(inner);
    object.giveBack("provenance", inner.rest());
  }
  if (const auto kept = object.take("atoms"))
    node.atoms = atomsFrom(*kept);
  node.unread = object.unread();
  return node;
}

Scene SceneJsonReader::scene(const JsonValue& root) {
  JsonObject object(root);
  for (const char* known : {"format", "schema"})
    object.need(known);
  for (const auto& [key, only] : {std::pair{"frame", "LPS"}, std::pair{"unit", "mm"}})
    if (const auto value = object.take(key); value && value->text() != only)
      value->fail("\"" + std::string(only) + "\" is expected here");
  std::vector<Node> nodes;
  TreeOrderCheck order;
  const JsonValue nodeList = object.need("nodes");
  if (nodeList.json().size() > mostNodes)
    nodeList.fail("there are more than " + std::to_string(mostNodes) + " nodes");
  nodeList.forEach([&](const JsonValue& value) {
    nodes.push_back(node(value));
    order.add(nodes.back(), value);
  });
  std::vector<Section> cuts;
  if (const auto list = object.take("sections"))
    cuts = sections(*list);
  std::vector<Annotation> notes;
  if (const auto list = object.take("annotations"))
    notes = annotations(*list, nodes);
  Focus focused;
  if (const auto value = object.take("focus"))
    focused = focus(*value);
  std::optional<KeyLight> light;
  if (const auto value = object.take("key_light"))
    light = keyLightFrom(*value);
  std::vector<View> views;
  if (const auto list = object.take("views")) {
    if (list->json().size() > mostViews)
      list->fail("there are more than " + std::to_string(mostViews) + " views");
    list->forEach([&](const JsonValue& value) { views.push_back(view(value)); });
  }
  std::vector<Scan> scans;
  if (const auto list = object.take("scans"))
    scans = scansFrom(*list, m_parts.voxels);
  Scene scene;
  if (root.fault().any())
    return scene;
  scene.setNodes(std::move(nodes));
  scene.setSections(std::move(cuts));
  scene.setAnnotations(std::move(notes));
  scene.setFocus(std::move(focused));
  scene.setKeyLight(std::move(light));
  scene.setScans(std::move(scans));
  scene.setViews(std::move(views));
  scene.setUnread(object.unread());
  return scene;
}

}  // namespace sline::model
