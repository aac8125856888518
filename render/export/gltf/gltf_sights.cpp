// SPDX-License-Identifier: Apache-2.0
#include "render/export/gltf/gltf_sights.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <utility>

#include "model/base/colour_text.h"
#include "model/scene/cut_place.h"
#include "model/scene/markup.h"
#include "model/scene/style_fields.h"
#include "model/scene_json/style_json.h"

namespace sline::render {

namespace {

constexpr std::array<const char*, 4> kindNames{"label", "callout", "pin", "distance"};

/// Returns what a style itself defines, as in scene files but for the form of the keys. How Γ
/// varies over a surface is said at its vertices.
Json ownStyleExtras(const model::Style& style) {
  Json extras = Json::object();
  model::Style said = style;
  said.gammaMap.reset();
  const Json own = model::styleJson(said);
  for (const auto& [key, value] : own.items())
    extras[model::camelCase(key)] = value;
  return extras;
}

/// Returns what is said in the scene's language and in others, without markup.
Json wordingExtras(const model::Wording& wording, bool markedUp) {
  const auto plain = [markedUp](const std::string& text) {
    return markedUp ? model::plainText(model::AnnotationKind::callout, text) : text;
  };
  Json said{{"text", plain(wording.text)}};
  for (const auto& [tag, text] : wording.texts)
    said["texts"][tag] = plain(text);
  return said;
}

}  // namespace

Json styleExtras(const model::ResolvedStyle& style) {
  // The material has those two, and a hidden structure is not in the file.
  model::Style said = model::answersOf(style);
  said.colour.reset();
  said.opacity.reset();
  said.visible.reset();
  if (style.lineThresholds.empty())
    said.lineThresholds.reset();
  // Comes last, as not every structure has one.
  const std::optional<Colour> ink = std::exchange(said.inkColour, std::nullopt);
  Json extras = ownStyleExtras(said);
  extras.update(ownStyleExtras({.inkColour = ink}));
  return extras;
}

Json gltfCamera(const model::Camera& camera, const model::Box& bounds) {
  const float distance = glm::length(camera.eye - camera.target);
  const float size = bounds.empty() ? distance : glm::length(bounds.size());
  const float middle = bounds.empty() ? distance : glm::length(camera.eye - bounds.centre());
  const float far = metresPerMillimetre * (middle + size);
  // A parallel projection's near plane may be at the eye; a perspective one's must be in front of
  // it.
  const float near = std::max(metresPerMillimetre * (middle - size), far / 4096.0f);
  if (camera.projection == model::Projection::perspective)
    return {{"type", "perspective"},
            {"perspective",
             {{"yfov", double(camera.fovyDegrees) * std::numbers::pi / 180.0},
              {"zfar", jsonNumber(far)},
              {"znear", jsonNumber(near)}}}};
  // Half of what the picture shows; the viewer widens it to the picture's shape.
  const Json half = jsonNumber(0.5f * metresPerMillimetre * camera.heightMm);
  return {
      {"type", "orthographic"},
      {"orthographic",
       {{"xmag", half}, {"ymag", half}, {"zfar", jsonNumber(far)}, {"znear", jsonNumber(near)}}}};
}

Json cameraPlace(const model::Camera& camera) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const glm::dmat3 turn =
      uprightFromLps() *
      glm::dmat3(glm::dvec3(frame.right), glm::dvec3(frame.up), glm::dvec3(frame.back));
  const glm::dquat q = glm::normalize(glm::quat_cast(turn));
  const glm::vec3 eye = metresPerMillimetre * glm::vec3(uprightFromLps() * glm::dvec3(camera.eye));
  return {{"rotation", {q.x, q.y, q.z, q.w}}, {"translation", jsonPoint(eye)}};
}

Json viewExtras(const model::Scene& scene, const model::View& view, const GltfNodes& nodes) {
  Json extras{{"eye", jsonPoint(view.camera.eye)},
              {"target", jsonPoint(view.camera.target)},
              {"up", jsonPoint(view.camera.up)}};
  if (!view.words.title.empty())
    extras["title"] = wordingExtras(view.words.title, false);
  if (!view.words.text.empty())
    extras["text"] = wordingExtras(view.words.text, true);
  if (view.looks) {
    extras["looks"] = Json::array();
    for (const model::Look& look : *view.looks) {
      const auto node = nodes.find(look.node);
      const Json said = ownStyleExtras(look.style);
      if (node == nodes.end() || said.empty())
        continue;
      Json entry{{"node", node->second}};
      entry.update(said);
      extras["looks"].push_back(std::move(entry));
    }
  }
  if (view.annotations) {
    extras["annotations"] = Json::array();
    for (const model::Annotation& annotation : scene.annotations())
      if (std::find(view.annotations->begin(), view.annotations->end(), annotation.id) !=
          view.annotations->end())
        extras["annotations"].push_back(annotation.id.value);
  }
  if (view.sections) {
    extras["sections"] = Json::array();
    for (const model::Section& section : *view.sections)
      extras["sections"].push_back(sectionExtras(section));
  }
  return extras;
}

Json annotationNode(const model::Scene& scene, const model::Annotation& annotation,
                    const std::string& language) {
  Json places = Json::array();
  for (const model::Anchor& anchor : model::pointedAt(annotation))
    if (const std::optional<glm::vec3> place = scene.placeOf(anchor))
      places.push_back(jsonPoint(*place));
  Json extras{{"annotation", kindNames[std::size_t(annotation.kind)]},
              {"id", annotation.id.value},
              {"text", model::plainText(annotation.kind, annotation.text)}};
  for (const auto& [tag, text] : annotation.texts)
    extras["texts"][tag] = model::plainText(annotation.kind, text);
  if (annotation.colour)
    extras["colour"] = colourText(*annotation.colour);
  extras["places"] = places;
  return {{"name", model::plainTextIn(annotation, language)},
          {"translation", places.front()},
          {"extras", std::move(extras)}};
}

Json sectionExtras(const model::Section& section) {
  return {{"name", section.name},
          {"normal", jsonPoint(section.plane.normal)},
          {"offset", jsonNumber(section.plane.offset)},
          {"enabled", section.enabled}};
}

}  // namespace sline::render
