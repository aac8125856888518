// SPDX-License-Identifier: Apache-2.0
// Writes and reads a style in scene.json (resources/help/scene_file.md).
#pragma once

#include <nlohmann/json.hpp>

#include "model/scene/style.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

/// Takes the fields of a style from the object. A fill that this program does not know is an error;
/// in a file of a newer schema it stays unread.
Style styleFrom(JsonObject& object, bool newer);
/// Returns the style's answers, in the order of model/scene/style_fields.h.
nlohmann::ordered_json styleJson(const Style& style);

}  // namespace sline::model
