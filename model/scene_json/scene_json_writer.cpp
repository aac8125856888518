// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "model/base/colour_text.h"
#include "model/scene/cut_place.h"
#include "model/scene/style_fields.h"
#include "model/scene_json/atoms_json.h"
#include "model/scene_json/camera_json.h"
#include "model/scene_json/provenance_json.h"
#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_json_names.h"
#include "model/scene_json/style_json.h"
#include "model/scene_json/trace_json.h"

namespace sline::model {

namespace {
/// Keeps its keys in the order in which they are written.
using Ordered = nlohmann::ordered_json;

/// Returns the same value with its keys in order; the keys are sorted and unique, so none is
/// searched for.
Ordered orderedOf(const Json& json) {
  if (json.is_array()) {
    Ordered list = Ordered::array();
    for (const Json& value : json)
      list.push_back(orderedOf(value));
    return list;
  }
  if (!json.is_object())
    return Ordered::parse(json.dump());
  Ordered object = Ordered::object();
  for (const auto& [key, value] : json.items())
    object.get_ref<Ordered::object_t&>().push_back({key, orderedOf(value)});
  return object;
}

/// Tells whether unread keys may be all that is written of a part. What a newer program says in
/// place of a field, and what it adds to one, makes no sense to this schema without the field.
bool mayStandAlone(std::string_view above, std::string_view part) {
  static constexpr std::array<std::array<std::string_view, 2>, 5> bound{
      {{"node", "paint"},
       {"provenance", "fingerprint"},
       {"provenance", "intensities"},
       {"focus", "seen_from"},
       {"focus", "nearness"}}};
  bool field = std::any_of(bound.begin(), bound.end(),
                           [&](const auto& each) { return each[0] == above && each[1] == part; });
  if (above == "style")
    forEachStyleField([&](const auto& each) { field = field || each.key == part; });
  return !field;
}

/// Tells whether the part is one of which all may be absent, and what it holds is known here.
bool isPartOf(std::string_view above, std::string_view part) {
  return (above == "node" && (part == "style" || part == "provenance")) ||
         (above == "look" && part == "style");
}

/// Adds the keys of `unread` that `target` lacks, object by object; `what` says what it is.
void addUnread(Ordered& target, const Json& unread, std::string_view what) {
  auto& keys = target.get_ref<Ordered::object_t&>();
  const std::size_t known = keys.size();
  for (const auto& [key, value] : unread.items()) {
    auto own = keys.begin();
    const auto end = own + std::ptrdiff_t(known);
    while (own != end && own->first != key)
      ++own;
    if (own != end && own->second.is_object() && value.is_object()) {
      addUnread(own->second, value, key);
    } else if (own == end && isPartOf(what, key) && value.is_object()) {
      Ordered rest = Ordered::object();
      addUnread(rest, value, key);
      if (!rest.empty())
        keys.push_back({key, std::move(rest)});
    } else if (own == end && mayStandAlone(what, key)) {
      keys.push_back({key, orderedOf(value)});
    }
  }
}

void addUnread(Ordered& target, const std::string& unread, std::string_view what = {}) {
  if (unread.empty())
    return;
  const Result<Json> kept = parseJson(unread);
  if (kept.ok() && kept->is_object())
    addUnread(target, *kept, what);
}

Ordered nodeOf(const Node& node, const std::map<MeshPtr, std::string>& names) {
  Ordered json = {{"id", node.id.value}};
  if (node.parent != rootId)
    json["parent"] = node.parent.value;
  json["name"] = node.name;
  if (!node.isGroup())
    json["mesh"] = {{"file", names.at(node.mesh)},
                    {"vertices", node.mesh->vertexCount()},
                    {"triangles", node.mesh->triangleCount()}};
  if (node.paint)
    json["paint"] = {{"file", paintName(node.id)}};
  if (node.style != Style())
    json["style"] = styleJson(node.style);
  if (node.drawn) {
    json["drawn_colour"] = {{"given", colourText(node.drawn->given)}};
    if (node.drawn->had)
      json["drawn_colour"]["had"] = colourText(*node.drawn->had);
  }
  if (node.locked)
    json["locked"] = true;
  if (node.provenance != Provenance())
    json["provenance"] = provenanceJson(node.provenance);
  if (node.atoms.set)
    json["atoms"] = atomsJson(*node.atoms.set);
  addUnread(json, node.unread, "node");
  return json;
}

Ordered sectionsOf(const std::vector<Section>& sections) {
  Ordered list = Ordered::array();
  for (const Section& section : sections) {
    Ordered json = {{"id", section.id.value},
                    {"name", section.name},
                    {"normal", jsonPoint(section.plane.normal)},
                    {"offset_mm", jsonNumber(section.plane.offset)}};
    if (section.scope != rootId)
      json["scope"] = section.scope.value;
    json["enabled"] = section.enabled;
    json["faces"] = cutFacesNames[std::size_t(section.faces)];
    json["hatched"] = section.hatched;
    addUnread(json, section.unread);
    list.push_back(std::move(json));
  }
  return list;
}

Ordered anchorOf(const Anchor& anchor) {
  if (const auto* place = std::get_if<glm::vec3>(&anchor))
    return {{"point_mm", jsonPoint(*place)}};
  const SurfacePoint& point = std::get<SurfacePoint>(anchor);
  return {{"structure", point.structure.value},
          {"triangle", point.triangle},
          {"weights", {jsonNumber(point.weights[0]), jsonNumber(point.weights[1])}}};
}

Ordered annotationOf(const Annotation& annotation) {
  Ordered json = {{"id", annotation.id.value},
                  {"kind", annotationKindNames[std::size_t(annotation.kind)]},
                  {"at", anchorOf(annotation.anchors[0])}};
  if (const glm::vec3* cut = cutPlaceOf(annotation))
    json["cut_mm"] = jsonPoint(*cut);
  else if (annotation.anchors.size() > 1)
    json["to"] = anchorOf(annotation.anchors[1]);
  json["text"] = annotation.text;
  if (!annotation.texts.empty())
    json["texts"] = annotation.texts;
  if (annotation.colour)
    json["colour"] = colourText(*annotation.colour);
  json["visible"] = annotation.visible;
  json["locked"] = annotation.locked;
  if (annotation.found)
    json["found"] = true;
  if (annotation.offset)
    json["offset"] = {jsonNumber(annotation.offset->x), jsonNumber(annotation.offset->y)};
  addUnread(json, annotation.unread);
  return json;
}

Ordered keyLightOf(const KeyLight& light) {
  Ordered json = {{"towards", jsonPoint(light.towards)}, {"shades", light.shades}};
  addUnread(json, light.unread);
  return json;
}

Ordered looksOf(const std::vector<Look>& looks) {
  Ordered list = Ordered::array();
  for (const Look& look : looks) {
    list.push_back({{"node", look.node.value}, {"style", styleJson(look.style)}});
    addUnread(list.back(), look.unread, "look");
  }
  return list;
}

Ordered focusOf(const Focus& focus) {
  Ordered json = {{"targets", Ordered::array()}, {"context", jsonNumber(focus.amount.value())}};
  for (const NodeId id : focus.targets)
    json["targets"].push_back(id.value);
  if (focus.seenFrom)
    json["seen_from"] = cameraJson(*focus.seenFrom);
  for (const auto& [id, role] : focus.wishes.roles)
    json["roles"][std::string(contextRoleNames[std::size_t(role)])].push_back(id.value);
  if (focus.wishes.hiddenToo)
    json["hidden_too"] = true;
  if (focus.nearness) {
    json["nearness"] = {{"falloff_mm", jsonNumber(focus.nearness->falloffMm)}};
    if (focus.nearness->place)
      json["nearness"]["place_mm"] = jsonPoint(*focus.nearness->place);
  }
  if (!focus.given.empty())
    json["given"] = looksOf(focus.given);
  addUnread(json, focus.unread, "focus");
  return json;
}

Ordered wordingOf(const Wording& wording) {
  Ordered json = {{"text", wording.text}};
  if (!wording.texts.empty())
    json["texts"] = wording.texts;
  return json;
}

void addWords(Ordered& json, const ViewWords& words) {
  for (const auto& [key, wording] :
       {std::pair("title", &words.title), std::pair("text", &words.text),
        std::pair("notes", &words.notes), std::pair("description", &words.description)})
    if (!wording->empty())
      json[key] = wordingOf(*wording);
  if (words.seconds)
    json["seconds"] = jsonNumber(*words.seconds);
}

Ordered viewOf(const View& view) {
  Ordered json = {{"name", view.name}, {"camera", cameraJson(view.camera)}};
  if (view.sections)
    json["sections"] = sectionsOf(*view.sections);
  if (view.looks)
    json["looks"] = looksOf(*view.looks);
  if (view.annotations) {
    json["annotations"] = Ordered::array();
    for (const AnnotationId id : *view.annotations)
      json["annotations"].push_back(id.value);
  }
  if (view.focus)
    json["focus"] = focusOf(*view.focus);
  addWords(json, view.words);
  addUnread(json, view.unread);
  return json;
}
}  // namespace

std::map<MeshPtr, std::string> meshNames(const Scene& scene) {
  std::map<MeshPtr, std::string> names;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      names.try_emplace(node.mesh, "meshes/" + std::to_string(node.id.value) + ".mesh");
  return names;
}

std::string paintName(NodeId structure) {
  return "paint/" + std::to_string(structure.value) + ".paint";
}

std::string sceneJson(const Scene& scene) {
  const std::map<MeshPtr, std::string> names = meshNames(scene);
  Ordered root = {
      {"format", formatName}, {"schema", sceneSchema}, {"frame", "LPS"}, {"unit", "mm"}};
  root["nodes"] = Ordered::array();
  for (const Node& node : scene.nodes())
    root["nodes"].push_back(nodeOf(node, names));
  root["sections"] = sectionsOf(scene.sections());
  root["annotations"] = Ordered::array();
  for (const Annotation& annotation : scene.annotations())
    root["annotations"].push_back(annotationOf(annotation));
  root["views"] = Ordered::array();
  for (const View& view : scene.views())
    root["views"].push_back(viewOf(view));
  if (scene.focus() != Focus())
    root["focus"] = focusOf(scene.focus());
  if (scene.keyLight())
    root["key_light"] = keyLightOf(*scene.keyLight());
  if (!scene.scans().empty())
    root["scans"] = Ordered::array();
  for (std::size_t n = 0; n < scene.scans().size(); ++n) {
    Ordered json = scanJson(scene.scans()[n], voxelsName(n));
    addUnread(json, scene.scans()[n].unread);
    root["scans"].push_back(std::move(json));
  }
  if (!scene.traces().empty())
    root["traces"] = Ordered::array();
  for (const SourceTrace& trace : scene.traces()) {
    Ordered json = traceJson(trace);
    addUnread(json, trace.unread);
    root["traces"].push_back(std::move(json));
  }
  addUnread(root, scene.unread());
  return root.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace sline::model
