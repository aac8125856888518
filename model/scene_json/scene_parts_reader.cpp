// SPDX-License-Identifier: Apache-2.0
// Reads the sections, annotations and views of a scene.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "model/scene_json/camera_json.h"
#include "model/scene_json/scene_json_names.h"
#include "model/scene_json/scene_reader.h"
#include "model/scene_json/style_json.h"

namespace sline::model {

namespace {

Anchor anchorFrom(JsonObject& object) {
  if (const auto place = object.take("point_mm"))
    return place->point();
  SurfacePoint point;
  point.structure.value = idOf(object.need("structure"));
  point.triangle = std::uint32_t(object.need("triangle").whole(0, std::uint32_t(-1)));
  point.weights = object.need("weights").numbers<2>();
  return point;
}

std::map<std::string, std::string> textsFrom(const JsonValue& value) {
  const JsonObject languages(value);  // notes a fault where it is not an object
  std::map<std::string, std::string> texts;
  if (value.json().is_object())
    for (const auto& [language, text] : value.json().items())
      if (auto words = sound(JsonValue(text, value, std::string_view(language)), asText))
        texts[language] = std::move(*words);
  return texts;
}

Wording wordingFrom(JsonObject& object, std::string_view key) {
  Wording wording;
  const auto value = object.take(key);
  if (!value)
    return wording;
  JsonObject inner(*value);
  readInto(inner.take("text"), wording.text, asText);
  if (const auto texts = inner.take("texts"))
    wording.texts = textsFrom(*texts);
  object.giveBack(key, inner.rest());
  return wording;
}

}  // namespace

Section SceneJsonReader::section(const JsonValue& value) const {
  JsonObject object(value);
  const FaultWatch watch(value.fault());
  Section section;
  section.id.value = idOf(object.need("id"));
  section.name = object.need("name").text();
  section.plane.normal = object.need("normal").point();
  section.plane.offset = object.need("offset_mm").number();
  if (const auto scope = object.take("scope"))
    section.scope.value = idOf(*scope);
  if (const auto enabled = object.take("enabled"))
    section.enabled = enabled->flag();
  // Files from before there were patterns show tints.
  section.faces = choice<CutFaces>(object, "faces", cutFacesNames).value_or(CutFaces::tint);
  if (const auto hatched = object.take("hatched"))
    section.hatched = hatched->flag();
  section.unread = object.unread();
  if (const auto fault = planeFault(section.plane); fault && watch.clean())
    value.fail(*fault);
  return section;
}

std::vector<Section> SceneJsonReader::sections(const JsonValue& list) const {
  std::vector<Section> all;
  std::set<SectionId> ids;
  list.forEach([&](const JsonValue& value) {
    auto read = sound(value, [this](const JsonValue& each) { return section(each); });
    if (!read)
      return;
    if (!ids.insert(read->id).second)
      return value.fail("another section has the same id");
    all.push_back(std::move(*read));
  });
  return all;
}

/// Reads what tells an annotation apart and where it points; without that there is none.
Annotation SceneJsonReader::place(JsonObject& object) const {
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
  else if (const auto cut = object.take("cut_mm"))
    annotation.anchors.emplace_back(cut->point());
  return annotation;
}

std::optional<Annotation> SceneJsonReader::annotation(const JsonValue& value) const {
  JsonObject object(value);
  const FaultWatch watch(value.fault());
  Annotation annotation = place(object);
  if (const auto fault = annotationFault(annotation); fault && watch.clean())
    value.fail(*fault);
  if (!watch.clean())
    return std::nullopt;
  readInto(object.take("text"), annotation.text, asText);
  if (const auto texts = object.take("texts"))
    annotation.texts = textsFrom(*texts);
  readInto(object.take("colour"), annotation.colour, [](const JsonValue& v) { return v.colour(); });
  readInto(object.take("visible"), annotation.visible, asFlag);
  readInto(object.take("locked"), annotation.locked, asFlag);
  readInto(object.take("found"), annotation.found, asFlag);
  readInto(object.take("offset"), annotation.offset, [](const JsonValue& v) {
    const auto [right, down] = v.numbers<2>();
    return glm::vec2(right, down);
  });
  if (const auto fault = annotationFault(annotation)) {
    value.fail(*fault);
    annotation.offset.reset();
  }
  annotation.unread = object.unread();
  return annotation;
}

std::vector<Annotation> SceneJsonReader::annotations(const JsonValue& list,
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
  list.forEach([&](const JsonValue& value) {
    auto read = annotation(value);
    if (!read)
      return;
    if (!ids.insert(read->id).second)
      return value.fail("another annotation has the same id");
    if (std::any_of(read->anchors.begin(), read->anchors.end(), nowhere))
      return value.fail("it is on a triangle that no structure of the scene has");
    all.push_back(std::move(*read));
  });
  return all;
}

std::vector<Look> SceneJsonReader::looks(const JsonValue& list) const {
  std::vector<Look> all;
  std::set<NodeId> nodes;
  list.forEach([&](const JsonValue& value) {
    JsonObject object(value);
    const auto node = sound(object.need("node"), idOf);
    if (!node)
      return;
    Look look{.node = {*node}};
    if (const auto own = object.take("style")) {
      JsonObject inner(*own);
      look.style = styleFrom(inner, m_newer);
      object.giveBack("style", inner.rest());
    }
    look.unread = object.unread();
    if (!nodes.insert(look.node).second)
      return value.fail("the view speaks of this node twice");
    all.push_back(std::move(look));
  });
  return all;
}

namespace {

template <class Id>
std::vector<Id> idsFrom(const JsonValue& list) {
  std::vector<Id> ids;
  list.forEach([&ids](const JsonValue& value) {
    if (const auto id = sound(value, idOf))
      ids.push_back(Id{*id});
  });
  return ids;
}

FocusNearness nearnessFrom(JsonObject& object) {
  FocusNearness nearness;
  const JsonValue falloff = object.need("falloff_mm");
  nearness.falloffMm = falloff.number();
  if (!nearnessFalloffs.contain(nearness.falloffMm))
    falloff.fail("a number from 1 to 2000 is expected here");
  if (const auto place = object.take("place_mm"))
    nearness.place = place->point();
  return nearness;
}

ContextAmount amountFrom(const JsonValue& value) {
  const auto known = ContextAmount::from(value.number());
  if (!known)
    value.fail("a number from 0 to 1 is expected here");
  return known.value_or(ContextAmount());
}

}  // namespace

Focus SceneJsonReader::focus(const JsonValue& value) const {
  JsonObject object(value);
  Focus focus;
  focus.targets = idsFrom<NodeId>(object.need("targets"));
  readInto(object.take("context"), focus.amount, amountFrom);
  const auto inside = [&object](std::string_view key, auto& target, const auto& read) {
    readInto(object.take(key), target, [&](const JsonValue& place) {
      JsonObject inner(place);
      auto got = read(inner);
      object.giveBack(key, inner.rest());
      return got;
    });
  };
  inside("seen_from", focus.seenFrom,
         [this](JsonObject& inner) { return cameraFrom(inner, m_newer); });
  if (const auto roles = object.take("roles")) {
    JsonObject inner(*roles);
    auto role = ContextRole(0);
    for (const auto& name : contextRoleNames) {
      if (const auto list = inner.take(name))
        for (const NodeId id : idsFrom<NodeId>(*list))
          focus.wishes.roles[id] = role;
      role = ContextRole(int(role) + 1);
    }
    object.giveBack("roles", inner.rest());
  }
  readInto(object.take("hidden_too"), focus.wishes.hiddenToo, asFlag);
  inside("nearness", focus.nearness, nearnessFrom);
  if (const auto list = object.take("given"))
    focus.given = looks(*list);
  focus.unread = object.unread();
  return focus;
}

namespace {

float secondsFrom(const JsonValue& value) {
  const float seconds = value.number();
  if (!viewSecondsLimits.contain(seconds))
    value.fail("a time from 0.1 to 3600 seconds is expected here");
  return seconds;
}

}  // namespace

std::optional<View> SceneJsonReader::view(const JsonValue& value) const {
  JsonObject object(value);
  View view{.name = "unnamed"};
  readInto(object.need("name"), view.name, asText);
  const FaultWatch watch(value.fault());
  const JsonValue place = object.need("camera");
  JsonObject inner(place);
  view.camera = cameraFrom(inner, m_newer);
  if (!watch.clean())
    return std::nullopt;
  object.giveBack("camera", inner.rest());
  if (const auto list = object.take("sections"))
    view.sections = sections(*list);
  if (const auto list = object.take("looks"))
    view.looks = looks(*list);
  if (const auto list = object.take("annotations"))
    view.annotations = idsFrom<AnnotationId>(*list);
  if (const auto focused = object.take("focus"))
    view.focus = focus(*focused);
  view.words = {.title = wordingFrom(object, "title"),
                .text = wordingFrom(object, "text"),
                .notes = wordingFrom(object, "notes"),
                .description = wordingFrom(object, "description")};
  readInto(object.take("seconds"), view.words.seconds, secondsFrom);
  view.unread = object.unread();
  return view;
}

std::vector<View> SceneJsonReader::views(const JsonValue& list) const {
  std::vector<View> all;
  list.forEach([&](const JsonValue& value) {
    if (std::optional<View> read = view(value))
      all.push_back(std::move(*read));
  });
  return all;
}

}  // namespace sline::model
