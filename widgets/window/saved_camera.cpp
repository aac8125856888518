// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/saved_camera.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace sline::widgets {

namespace {

constexpr const char* memberName = "workspace.json";

// Keys are those of a view's camera in scene.json (resources/help/scene_file.md).
constexpr QLatin1String cameraKey("camera");
constexpr QLatin1String projectionKey("projection");
constexpr QLatin1String eyeKey("eye_mm");
constexpr QLatin1String targetKey("target_mm");
constexpr QLatin1String upKey("up");
constexpr QLatin1String openingKey("opening_degrees");
constexpr QLatin1String heightKey("height_mm");
constexpr QLatin1String orthographic("orthographic");

QJsonArray arrayOf(const glm::vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

glm::vec3 vectorOf(const QJsonValue& value) {
  const QJsonArray array = value.toArray();
  return {float(array[0].toDouble()), float(array[1].toDouble()), float(array[2].toDouble())};
}

}  // namespace

model::ZipMember memberFor(const model::Camera& camera) {
  QJsonObject object{{eyeKey, arrayOf(camera.eye)},
                     {targetKey, arrayOf(camera.target)},
                     {upKey, arrayOf(camera.up)}};
  if (camera.projection == model::Projection::orthographic) {
    object[projectionKey] = orthographic;
    object[heightKey] = double(camera.heightMm);
  } else {
    object[openingKey] = double(camera.fovyDegrees);
  }
  return {memberName, QJsonDocument(QJsonObject{{cameraKey, object}}).toJson().toStdString()};
}

std::optional<model::Camera> cameraIn(const DocumentFile& file) {
  if (!file.others)
    return std::nullopt;
  const auto member = std::find_if(file.others->begin(), file.others->end(),
                                   [](const auto& each) { return each.name == memberName; });
  if (member == file.others->end())
    return std::nullopt;
  const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(member->bytes))
                                 .object()[cameraKey]
                                 .toObject();
  model::Camera camera;
  camera.eye = vectorOf(object[eyeKey]);
  camera.target = vectorOf(object[targetKey]);
  camera.up = vectorOf(object[upKey]);
  if (object[projectionKey].toString() == orthographic)
    camera.projection = model::Projection::orthographic;
  camera.heightMm = float(object[heightKey].toDouble(double(camera.heightMm)));
  camera.fovyDegrees = float(object[openingKey].toDouble(double(camera.fovyDegrees)));
  return model::cameraFault(camera) ? std::nullopt : std::optional(camera);
}

}  // namespace sline::widgets
