// SPDX-License-Identifier: Apache-2.0
#include "app/cli/camera_file.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/text_file.h"

namespace sline::cli {

namespace {

using model::Camera;
using nlohmann::json;

constexpr std::string_view remedy =
    R"(Write it as {"projection":"perspective","eye":[0,-900,0],"target":[0,0,0],"up":[0,0,1],)"
    R"("fovy_deg":30}, or "orthographic" with "height_mm")";

Error wrong(std::string where, std::string reason) {
  return Error{
      .where = std::move(where), .reason = std::move(reason), .remedy = std::string(remedy)};
}

Status readNumber(const json& value, const std::string& key, float& target) {
  if (!value.is_number() || !std::isfinite(value.get<float>()))
    return wrong(key, "it is not a number");
  target = value.get<float>();
  return Unit{};
}

Status readPoint(const json& value, const std::string& key, glm::vec3& target) {
  if (!value.is_array() || value.size() != 3)
    return wrong(key, "it is not a list of three numbers");
  for (int i = 0; i < 3; ++i)
    if (Status read = readNumber(value[std::size_t(i)], key, target[i]); !read.ok())
      return read;
  return Unit{};
}

Status readProjection(const json& value, Camera& camera) {
  if (value == "perspective")
    camera.projection = model::Projection::perspective;
  else if (value == "orthographic")
    camera.projection = model::Projection::orthographic;
  else
    return wrong("projection", "it is neither \"perspective\" nor \"orthographic\"");
  return Unit{};
}

Status readKey(const std::string& key, const json& value, Camera& camera) {
  if (key == "projection")
    return readProjection(value, camera);
  if (key == "eye")
    return readPoint(value, key, camera.eye);
  if (key == "target")
    return readPoint(value, key, camera.target);
  if (key == "up")
    return readPoint(value, key, camera.up);
  if (key == "fovy_deg")
    return readNumber(value, key, camera.fovyDegrees);
  if (key == "height_mm")
    return readNumber(value, key, camera.heightMm);
  return wrong(key, "a camera has no such key");
}

Result<json> parsed(std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& failure) {
    return wrong("byte " + std::to_string(failure.byte), "it is not JSON");
  } catch (const json::exception&) {  // a number too large for any type
    return wrong({}, "it is not JSON");
  }
}

}  // namespace

Result<Camera> parseCamera(std::string_view text) {
  const Result<json> root = parsed(text);
  if (!root.ok())
    return root.error();
  if (!root->is_object())
    return wrong({}, "a camera is a JSON object");
  for (const char* needed : {"eye", "target"})
    if (!root->contains(needed))
      return wrong(needed, "it is missing");
  Camera camera;
  for (const auto& [key, value] : root->items())
    if (Status read = readKey(key, value, camera); !read.ok())
      return read.error();
  if (camera.projection == model::Projection::orthographic && !root->contains("height_mm"))
    return wrong("height_mm", "an orthographic camera needs it");
  if (const auto fault = model::cameraFault(camera))
    return wrong({}, std::string(*fault));
  return camera;
}

Result<Camera> readCamera(const std::filesystem::path& file) {
  const Result<std::string> text = readText(file, 1 << 20);
  if (!text.ok())
    return text.error();
  Result<Camera> camera = parseCamera(*text);
  if (camera.ok())
    return camera;
  Error error = camera.error();
  error.file = file.string();
  return error;
}

}  // namespace sline::cli
