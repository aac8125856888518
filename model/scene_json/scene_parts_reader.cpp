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

constexpr std::size_t mostSections = 10'000;
constexpr std::size_t mostAnnotations = 100'000;

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
  for (const auto& [language, text] : value.json().items())
    texts[language] = JsonValue(text, value, std::string_view(language)).text();
  return texts;
}

Wording wordingFrom(JsonObject& object, std::string_view key) {
  Wording wording;
  const auto value = object.take(key);
  if (!value)
    return wording;
  JsonObject inner(*value);
  if (const auto text = inner.take("text"))
    wording.text = text->text();
  if (const auto texts = inner.take("texts"))
    wording.texts = textsFrom(*texts);
  object.giveBack(key, inner.rest());
  return wording;
}

}  // namespace

Section SceneJsonReader::section(const JsonValue& value) const {
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
  // Files from before there were patterns show tints.
  section.faces = choice<CutFaces>(object, "faces", cutFacesNames).value_or(CutFaces::tint);
  if (const auto hatched = object.take("hatched"))
    section.hatched = hatched->flag();
  section.unread = object.unread();
  if (const auto fault = planeFault(section.plane))
    value.fail(*fault);
  return section;
}

std::vector<Section> SceneJsonReader::sections(const JsonValue& list) const {
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

Annotation SceneJsonReader::annotation(const JsonValue& value) const {
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
  else if (const auto cut = object.take("cut_mm"))
    annotation.anchors.emplace_back(cut->point());
  if (const auto text = object.take("text"))
    annotation.text = text->text();
  if (const auto texts = object.take("texts"))
    annotation.texts = textsFrom(*texts);
  if (const auto colour = object.take("colour"))
    annotation.colour = colour->colour();
  if (const auto visible = object.take("visible"))
    annotation.visible = visible->flag();
  if (const auto locked = object.take("locked"))
    annotation.locked = locked->flag();
  if (const auto found = object.take("found"))
    annotation.found = found->flag();
  if (const auto offset = object.take("offset")) {
    const auto [right, down] = offset->numbers<2>();
    annotation.offset = {right, down};
  }
  annotation.unread = object.unread();
  if (const auto fault = annotationFault(annotation))
    value.fail(*fault);
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

std::vector<Look> SceneJsonReader::looks(const JsonValue& list) const {
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

namespace {
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
}  // namespace

Focus SceneJsonReader::focus(const JsonValue& value) const {
  JsonObject object(value);
  Focus focus;
  object.need("targets").forEach(
      [&focus](const JsonValue& id) { focus.targets.push_back(NodeId{idOf(id)}); });
  if (const auto amount = object.take("context")) {
    const auto known = ContextAmount::from(amount->number());
    if (!known)
      amount->fail("a number from 0 to 1 is expected here");
    focus.amount = known.value_or(focus.amount);
  }
  if (const auto place = object.take("seen_from")) {
    JsonObject inner(*place);
    focus.seenFrom = cameraFrom(inner, m_newer);
    object.giveBack("seen_from", inner.rest());
  }
  if (const auto roles = object.take("roles")) {
    JsonObject inner(*roles);
    auto role = ContextRole(0);
    for (const auto& name : contextRoleNames) {
      if (const auto list = inner.take(name))
        list->forEach([&](const JsonValue& id) { focus.wishes.roles[NodeId{idOf(id)}] = role; });
      role = ContextRole(int(role) + 1);
    }
    object.giveBack("roles", inner.rest());
  }
  if (const auto too = object.take("hidden_too"))
    focus.wishes.hiddenToo = too->flag();
  if (const auto near = object.take("nearness")) {
    JsonObject inner(*near);
    focus.nearness = nearnessFrom(inner);
    object.giveBack("nearness", inner.rest());
  }
  if (const auto list = object.take("given"))
    focus.given = looks(*list);
  focus.unread = object.unread();
  return focus;
}

View SceneJsonReader::view(const JsonValue& value) const {
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
  if (const auto focused = object.take("focus"))
    view.focus = focus(*focused);
  view.words = {.title = wordingFrom(object, "title"),
                .text = wordingFrom(object, "text"),
                .notes = wordingFrom(object, "notes"),
                .description = wordingFrom(object, "description")};
  if (const auto seconds = object.take("seconds")) {
    view.words.seconds = seconds->number();
    if (!viewSecondsLimits.contain(*view.words.seconds))
      seconds->fail("a time from 0.1 to 3600 seconds is expected here");
  }
  view.unread = object.unread();
  return view;
}

}  // namespace sline::model
