// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "model/scene_file/camera_json.h"
#include "model/scene_file/provenance_json.h"
#include "model/scene_file/scene_json.h"
#include "model/scene_file/scene_json_names.h"
#include "model/scene_file/style_json.h"

namespace sline::model {

namespace {
constexpr std::size_t mostNodes = 100'000;
constexpr std::size_t mostSections = 10'000;
constexpr std::size_t mostViews = 10'000;
constexpr std::size_t mostAnnotations = 100'000;
constexpr std::size_t deepestNode = 256;
/// Ids up to this one stay exact in programs whose only numbers are doubles.
constexpr std::int64_t largestId = std::int64_t(1) << 53;

class SceneReader {
 public:
  SceneReader(const MeshesByName& meshes, const VoxelsByName& voxels, bool newer)
      : m_meshes(meshes), m_voxels(voxels), m_newer(newer) {}

  Scene scene(const JsonValue& root);

 private:
  template <class Enum>
  std::optional<Enum> choice(JsonObject& object, std::string_view key,
                             std::span<const std::string_view> names) const {
    const std::optional<std::size_t> index = object.takeChoice(key, names, m_newer);
    return index ? std::optional(Enum(*index)) : std::nullopt;
  }
  MeshPtr mesh(JsonObject& object) const;
  Node node(const JsonValue& value) const;
  Section section(const JsonValue& value) const;
  std::vector<Section> sections(const JsonValue& list) const;
  Annotation annotation(const JsonValue& value) const;
  std::vector<Annotation> annotations(const JsonValue& list, const std::vector<Node>& nodes) const;
  std::vector<Look> looks(const JsonValue& list) const;
  View view(const JsonValue& value) const;

  const MeshesByName& m_meshes;
  const VoxelsByName& m_voxels;
  bool m_newer;
};

std::uint64_t idOf(const JsonValue& value) {
  return std::uint64_t(value.whole(1, largestId));
}

MeshPtr SceneReader::mesh(JsonObject& object) const {
  const JsonValue file = object.need("file");
  const auto found = m_meshes.find(file.text());
  if (found == m_meshes.end()) {
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

Node SceneReader::node(const JsonValue& value) const {
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
  node.unread = object.unread();
  return node;
}

Section SceneReader::section(const JsonValue& value) const {
  JsonObject object(value);
  Section section;
  section.id.value = idOf(object.need("id"));
  section.name = object.need("name").text();
  section.plane.normal = object.need("normal").point();
  section.plane.offset = object.need("offset_mm").number();
  if (const auto scope = object.take("scope"))
    section.scope.value = idOf(*scope);
  if (const auto enabled = object.take("enabled"))
    section.enabled = enabled->flag();
  if (const auto hatched = object.take("hatched"))
    section.hatched = hatched->flag();
  section.unread = object.unread();
  if (const auto fault = planeFault(section.plane))
    value.fail(*fault);
  return section;
}

std::vector<Section> SceneReader::sections(const JsonValue& list) const {
  std::vector<Section> all;
  std::set<SectionId> ids;
  if (list.json().size() > mostSections)
    list.fail("there are more than " + std::to_string(mostSections) + " sections");
  list.forEach([&](const JsonValue& value) {
    all.push_back(section(value));
    if (!ids.insert(all.back().id).second)
      value.fail("another section has the same id");
  });
  return all;
}

Anchor anchorFrom(JsonObject& object) {
  if (const auto place = object.take("point_mm"))
    return place->point();
  SurfacePoint point;
  point.structure.value = idOf(object.need("structure"));
  point.triangle = std::uint32_t(object.need("triangle").whole(0, std::uint32_t(-1)));
  point.weights = object.need("weights").numbers<2>();
  return point;
}

Annotation SceneReader::annotation(const JsonValue& value) const {
  JsonObject object(value);
  Annotation annotation;
  annotation.id.value = idOf(object.need("id"));
  annotation.kind =
      choice<AnnotationKind>(object, "kind", annotationKindNames).value_or(AnnotationKind::label);
  const auto place = [&](std::string_view key) {
    const JsonValue anchor = object.need(key);
    JsonObject inner(anchor);
    annotation.anchors.push_back(anchorFrom(inner));
    object.giveBack(key, inner.rest());
  };
  place("at");
  if (anchorCount(annotation.kind) > 1)
    place("to");
  if (const auto text = object.take("text"))
    annotation.text = text->text();
  if (const auto texts = object.take("texts")) {
    const JsonObject languages(*texts);  // notes a fault where it is not an object
    for (const auto& [language, text] : texts->json().items())
      annotation.texts[language] = JsonValue(text, *texts, std::string_view(language)).text();
  }
  if (const auto colour = object.take("colour"))
    annotation.colour = colour->colour();
  if (const auto visible = object.take("visible"))
    annotation.visible = visible->flag();
  if (const auto locked = object.take("locked"))
    annotation.locked = locked->flag();
  if (const auto offset = object.take("offset")) {
    const auto [right, down] = offset->numbers<2>();
    annotation.offset = {right, down};
  }
  annotation.unread = object.unread();
  if (const auto fault = annotationFault(annotation))
    value.fail(*fault);
  return annotation;
}

std::vector<Annotation> SceneReader::annotations(const JsonValue& list,
                                                 const std::vector<Node>& nodes) const {
  std::map<NodeId, std::size_t> triangles;
  for (const Node& node : nodes)
    triangles[node.id] = node.mesh ? node.mesh->triangleCount() : 0;
  const auto nowhere = [&triangles](const Anchor& anchor) {
    const auto* point = std::get_if<SurfacePoint>(&anchor);
    if (!point)
      return false;
    const auto structure = triangles.find(point->structure);
    return structure == triangles.end() || point->triangle >= structure->second;
  };
  std::vector<Annotation> all;
  std::set<AnnotationId> ids;
  if (list.json().size() > mostAnnotations)
    list.fail("there are more than " + std::to_string(mostAnnotations) + " annotations");
  list.forEach([&](const JsonValue& value) {
    all.push_back(annotation(value));
    if (!ids.insert(all.back().id).second)
      value.fail("another annotation has the same id");
    if (std::any_of(all.back().anchors.begin(), all.back().anchors.end(), nowhere))
      value.fail("it is on a triangle that no structure of the scene has");
  });
  return all;
}

std::vector<Look> SceneReader::looks(const JsonValue& list) const {
  std::vector<Look> all;
  std::set<NodeId> nodes;
  list.forEach([&](const JsonValue& value) {
    JsonObject object(value);
    Look look;
    look.node.value = idOf(object.need("node"));
    if (const auto own = object.take("style")) {
      JsonObject inner(*own);
      look.style = styleFrom(inner, m_newer);
      object.giveBack("style", inner.rest());
    }
    look.unread = object.unread();
    if (!nodes.insert(look.node).second)
      value.fail("the view speaks of this node twice");
    all.push_back(std::move(look));
  });
  return all;
}

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

View SceneReader::view(const JsonValue& value) const {
  JsonObject object(value);
  View view;
  view.name = object.need("name").text();
  const JsonValue place = object.need("camera");
  JsonObject inner(place);
  view.camera = cameraFrom(inner, m_newer);
  object.giveBack("camera", inner.rest());
  if (const auto list = object.take("sections"))
    view.sections = sections(*list);
  if (const auto list = object.take("looks"))
    view.looks = looks(*list);
  if (const auto list = object.take("annotations"))
    list->forEach([&shown = view.annotations.emplace()](const JsonValue& id) {
      shown.push_back(AnnotationId{idOf(id)});
    });
  view.unread = object.unread();
  return view;
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

Scene SceneReader::scene(const JsonValue& root) {
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
    scans = scansFrom(*list, m_voxels);
  Scene scene;
  if (root.fault().any())
    return scene;
  scene.setNodes(std::move(nodes));
  scene.setSections(std::move(cuts));
  scene.setAnnotations(std::move(notes));
  scene.setKeyLight(std::move(light));
  scene.setScans(std::move(scans));
  scene.setViews(std::move(views));
  scene.setUnread(object.unread());
  return scene;
}

Error errorOf(const JsonFault& fault) {
  return {.where = fault.where, .reason = fault.reason};
}
}  // namespace

Result<int> schemaOf(const Json& root) {
  JsonFault fault;
  const JsonValue value(root, fault);
  JsonObject object(value);
  const JsonValue format = object.need("format");
  if (format.text() != formatName)
    format.fail("it is no scene of Sline");
  const auto schema = int(object.need("schema").whole(1, std::numeric_limits<int>::max()));
  if (fault.any())
    return errorOf(fault);
  return schema;
}

std::vector<std::string> meshesCalledFor(const Json& root) {
  std::set<std::string> names;
  const auto nodes = root.is_object() ? root.find("nodes") : root.end();
  if (nodes == root.end() || !nodes->is_array())
    return {};
  for (const Json& node : *nodes) {
    const auto mesh = node.is_object() ? node.find("mesh") : node.end();
    if (mesh == node.end() || !mesh->is_object())
      continue;
    const auto file = mesh->find("file");
    if (file != mesh->end() && file->is_string())
      names.insert(file->get<std::string>());
  }
  return {names.begin(), names.end()};
}

Result<Scene> sceneFromJson(const Json& root, const MeshesByName& meshes,
                            const VoxelsByName& voxels) {
  const Result<int> schema = schemaOf(root);
  if (!schema.ok())
    return schema.error();
  JsonFault fault;
  Scene scene = SceneReader(meshes, voxels, *schema > sceneSchema).scene(JsonValue(root, fault));
  if (fault.any())
    return errorOf(fault);
  return scene;
}

}  // namespace sline::model
