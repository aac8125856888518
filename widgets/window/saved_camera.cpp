// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/saved_camera.h"

#include <algorithm>

#include "model/scene_json/camera_json.h"

namespace sline::widgets {

namespace {
constexpr const char* memberName = "workspace.json";
constexpr const char* cameraKey = "camera";
}  // namespace

model::ZipMember memberFor(const model::Camera& camera) {
  const nlohmann::ordered_json workspace{{cameraKey, model::cameraJson(camera)}};
  return {memberName, workspace.dump(1)};
}

std::optional<model::Camera> cameraIn(const DocumentFile& file) {
  if (!file.others)
    return std::nullopt;
  const auto member = std::find_if(file.others->begin(), file.others->end(),
                                   [](const auto& each) { return each.name == memberName; });
  if (member == file.others->end())
    return std::nullopt;
  const Result<model::Json> workspace = model::parseJson(member->bytes);
  if (!workspace.ok() || !workspace->is_object() || !workspace->contains(cameraKey))
    return std::nullopt;
  model::JsonFault fault;
  model::JsonObject object(model::JsonValue((*workspace)[cameraKey], fault));
  const model::Camera camera = model::cameraFrom(object, true);
  return fault.any() ? std::nullopt : std::optional(camera);
}

}  // namespace sline::widgets
