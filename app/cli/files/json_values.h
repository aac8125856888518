// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "model/geometry/mesh.h"
#include "model/scene_json/json_value.h"

namespace sline::cli {

using Json = nlohmann::ordered_json;

using model::jsonNumber;
using model::jsonPoint;
/// Returns [[x, y, z], [x, y, z]], the low and the high corner; null for an empty box.
Json jsonBox(const model::Box& box);
/// Returns the text; bytes that are no UTF-8 become U+FFFD.
std::string jsonText(const Json& json, int indent = -1);

}  // namespace sline::cli
