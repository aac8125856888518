// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/camera_json.h"

#include <array>
#include <utility>

#include "model/scene_json/scene_json_names.h"

namespace sline::model {

namespace {

using Ordered = nlohmann::ordered_json;

constexpr std::array<std::pair<const char*, const char*>, 3> shortNames{
    {{"eye", "eye_mm"}, {"target", "target_mm"}, {"fovy_deg", "opening_degrees"}}};

Error refusal(const JsonRefusal& fault) {
  return {.where = fault.where,
          .reason = fault.reason,
          .remedy =
              "Write it as {\"projection\":\"perspective\",\"eye_mm\":[0,-900,0],"
              "\"target_mm\":[0,0,0],\"up\":[0,0,1],\"opening_degrees\":30}, or "
              "\"orthographic\" with \"height_mm\""};
}

/// Gives the object the names of scene.json, and the head for `up` where that is absent.
void completeNames(Json& camera) {
  for (const auto& [brief, name] : shortNames)
    if (const auto found = camera.find(brief); found != camera.end() && !camera.contains(name)) {
      Json value = std::move(*found);
      camera.erase(found);
      camera[name] = std::move(value);
    }
  if (!camera.contains("up"))
    camera["up"] = Json::array({Camera().up.x, Camera().up.y, Camera().up.z});
}

}  // namespace

Camera cameraFrom(JsonObject& object, bool newer) {
  const FaultWatch watch(object.value().fault());
  Camera camera;
  if (const auto index = object.takeChoice("projection", projectionNames, newer))
    camera.projection = Projection(*index);
  camera.eye = object.need("eye_mm").point();
  camera.target = object.need("target_mm").point();
  camera.up = object.need("up").point();
  if (const auto opening = object.take("opening_degrees"))
    camera.fovyDegrees = opening->number();
  if (const auto height = object.take("height_mm"))
    camera.heightMm = height->number();
  if (const auto fault = cameraFault(camera); fault && watch.clean())
    object.value().fail(*fault);
  return camera;
}

Ordered cameraJson(const Camera& camera) {
  return {{"projection", projectionNames[std::size_t(camera.projection)]},
          {"eye_mm", jsonPoint(camera.eye)},
          {"target_mm", jsonPoint(camera.target)},
          {"up", jsonPoint(camera.up)},
          {"opening_degrees", jsonNumber(camera.fovyDegrees)},
          {"height_mm", jsonNumber(camera.heightMm)}};
}

Result<Camera> parseCamera(std::string_view text) {
  Result<Json> parsed = parseJson(text, {.bytes = std::size_t(1) << 20});
  if (!parsed.ok())
    return refusal({parsed.error().where, "it is not JSON: " + parsed.error().reason});
  Json& root = *parsed;
  if (root.is_object())
    completeNames(root);
  JsonFault fault;
  const JsonValue value(root, fault);
  JsonObject object(value);
  const bool tall = root.is_object() && root.contains("height_mm");
  const Camera camera = cameraFrom(object, false);
  if (const Json rest = object.rest(); rest.is_object() && !rest.empty())
    JsonValue(rest.front(), value, rest.items().begin().key()).fail("a camera has no such key");
  if (camera.projection == Projection::orthographic && !tall)
    value.fail("an orthographic camera needs \"height_mm\"");
  if (fault.any())
    return refusal(fault);
  return camera;
}

}  // namespace sline::model
