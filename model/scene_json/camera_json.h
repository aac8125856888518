// SPDX-License-Identifier: Apache-2.0
// A camera as it stands in scene.json, in a camera file and in a document's workspace
// (resources/help/scene_file.md): one vocabulary for all of them.
#pragma once

#include <string_view>

#include "model/base/result.h"
#include "model/camera/camera.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Takes a camera from the object. A projection that this program does not know is an error; in a
/// file of a newer schema it stays unread. A camera that could not see is an error at the object.
Camera cameraFrom(JsonObject& object, bool newer);
/// Returns all that the camera is, in the order of the description.
nlohmann::ordered_json cameraJson(const Camera& camera);

/// Reads a camera that a person wrote: the object alone, where `up` (the head), the projection and
/// its number may be absent and have the defaults of `Camera`. "eye", "target" and "fovy_deg" stand
/// for "eye_mm", "target_mm" and "opening_degrees". Keys that are not known are refused, so that a
/// typing error shows; an orthographic camera needs its height.
Result<Camera> parseCamera(std::string_view text);

}  // namespace sline::model
