// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/scene_reader.h"

#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "model/scene_json/atoms_json.h"
#include "model/scene_json/provenance_json.h"
#include "model/scene_json/style_json.h"
#include "model/scene_json/trace_json.h"

namespace sline::model {

namespace {

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
/// groups. What is at fault goes to the top, and has no id until it gets one.
class TreeOrder {
 public:
  void add(Node& node, const JsonValue& value) {
    while (m_open.size() > 1 && m_open.back() != node.parent)
      m_open.pop_back();
    if (m_open.back() != node.parent) {
      value.fail("its parent is not among the groups that are open before it");
      node.parent = rootId;
    }
    if (node.id != rootId && !m_ids.insert(node.id.value).second) {
      value.fail("another node has the same id");
      node.id = rootId;
    }
    if (node.isGroup() && node.id != rootId)
      m_open.push_back(node.id);
  }
  /// Gives nodes without an id one that no other has.
  void complete(std::vector<Node>& nodes) {
    std::uint64_t next = 1;
    for (Node& node : nodes) {
      if (node.id != rootId)
        continue;
      while (!m_ids.insert(next).second)
        ++next;
      node.id.value = next;
    }
  }

 private:
  std::unordered_set<std::uint64_t> m_ids;
  std::vector<NodeId> m_open{rootId};
};

/// Returns the value of a list that has no more elements than that; what is longer is at fault as a
/// whole.
template <class Items, class Read>
Items listOf(const std::optional<JsonValue>& list, std::size_t most, const char* what,
             const Read& read) {
  if (!list)
    return {};
  if (list->json().size() > most) {
    list->fail("there are more than " + std::to_string(most) + " " + what);
    return {};
  }
  return read(*list);
}

}  // namespace

MeshPtr SceneJsonReader::mesh(JsonObject& object) const {
  const JsonValue file = object.need("file");
  const auto found = m_parts.meshes.find(file.text());
  if (found == m_parts.meshes.end()) {
    file.fail(absenceOf(file.text(), m_parts.damaged, "the file holds no such mesh") +
              "; the structure stays as an empty row");
    return nullptr;
  }
  const MeshPtr& mesh = found->second;
  const auto promised = [&object](std::string_view key, std::size_t count) {
    const auto value = object.take(key);
    if (value && value->whole(0, std::int64_t(largestId)) != std::int64_t(count))
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
    file.fail(absenceOf(file.text(), m_parts.damaged, "the file holds no such paint"));
    return nullptr;
  }
  if (found->second->size() != mesh.vertexCount()) {
    file.fail("it has " + std::to_string(found->second->size()) + " values, and the mesh " +
              std::to_string(mesh.vertexCount()) + " vertices");
    return nullptr;
  }
  return found->second;
}

void SceneJsonReader::look(JsonObject& object, Node& node) const {
  if (const auto painted = object.take("paint")) {
    JsonObject inner(*painted);
    if (node.mesh)
      node.paint = paint(inner, *node.mesh);
    else
      painted->fail("a node without a mesh has nothing to paint on");
    if (node.paint)
      object.giveBack("paint", inner.rest());
  }
  if (const auto own = object.take("style")) {
    JsonObject inner(*own);
    node.style = styleFrom(inner, m_newer);
    object.giveBack("style", inner.rest());
  }
  if (const auto drawn = object.take("drawn_colour")) {
    JsonObject inner(*drawn);
    const auto asColour = [](const JsonValue& value) { return value.colour(); };
    std::optional<Colour> given;
    std::optional<Colour> had;
    readInto(inner.need("given"), given, asColour);
    readInto(inner.take("had"), had, asColour);
    if (given)
      node.drawn = DrawnColour{*given, had};
    object.giveBack("drawn_colour", inner.rest());
  }
}

Node SceneJsonReader::node(const JsonValue& value) const {
  JsonObject object(value);
  Node node;
  readInto(object.need("id"), node.id.value, idOf);
  readInto(object.take("parent"), node.parent.value, idOf);
  node.name = "unnamed";
  readInto(object.need("name"), node.name, asText);
  if (const auto reference = object.take("mesh")) {
    JsonObject inner(*reference);
    node.mesh = mesh(inner);
    if (node.mesh)
      object.giveBack("mesh", inner.rest());
    else  // what lies on the surface and in it is gone with it
      for (const char* part : {"paint", "atoms"})
        object.take(part);
  }
  look(object, node);
  readInto(object.take("locked"), node.locked, asFlag);
  if (const auto origin = object.take("provenance")) {
    JsonObject inner(*origin);
    node.provenance = provenanceFrom(inner);
    object.giveBack("provenance", inner.rest());
  }
  readInto(object.take("atoms"), node.atoms, atomsFrom);
  node.unread = object.unread();
  return node;
}

std::vector<Node> SceneJsonReader::nodes(const JsonValue& list) const {
  std::vector<Node> nodes;
  TreeOrder order;
  list.forEach([&](const JsonValue& value) {
    if (!value.json().is_object())
      return value.fail("an object is expected here");
    Node read = node(value);
    order.add(read, value);
    nodes.push_back(std::move(read));
  });
  order.complete(nodes);
  return nodes;
}

Scene SceneJsonReader::scene(const JsonValue& root) {
  JsonObject object(root);
  for (const char* known : {"format", "schema", "frame", "unit"})
    object.take(known);
  const auto items = [&object](auto& target, const char* key, std::size_t most, const auto& read) {
    target = listOf<std::remove_reference_t<decltype(target)>>(object.take(key), most, key, read);
  };
  std::vector<Node> all;
  std::vector<Section> cuts;
  std::vector<Annotation> notes;
  std::vector<View> saved;
  std::vector<Scan> scans;
  std::vector<SourceTrace> traces;
  items(all, "nodes", mostSceneNodes, [&](const JsonValue& list) { return nodes(list); });
  items(cuts, "sections", mostSceneSections, [&](const JsonValue& list) { return sections(list); });
  items(notes, "annotations", mostSceneLabels,
        [&](const JsonValue& list) { return annotations(list, all); });
  Focus focused;
  if (const auto value = object.take("focus"))
    focused = focus(*value);
  std::optional<KeyLight> light;
  readInto(object.take("key_light"), light, keyLightFrom);
  items(saved, "views", mostSceneViews, [&](const JsonValue& list) { return views(list); });
  items(scans, "scans", mostSceneScans,
        [&](const JsonValue& list) { return scansFrom(list, m_parts.voxels, m_parts.damaged); });
  items(traces, "traces", mostSourceTraces, tracesFrom);
  Scene scene;
  if (root.fault().ends())
    return scene;
  scene.setNodes(std::move(all));
  scene.setSections(std::move(cuts));
  scene.setAnnotations(std::move(notes));
  scene.setFocus(std::move(focused));
  scene.setKeyLight(std::move(light));
  scene.setScans(std::move(scans));
  scene.setTraces(std::move(traces));
  scene.setViews(std::move(saved));
  scene.setUnread(object.unread());
  return scene;
}

}  // namespace sline::model
