// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "model/geometry/mesh.h"
#include "model/scene_file/json_value.h"

namespace sline::cli {

using Json = nlohmann::ordered_json;

using model::jsonNumber;
using model::jsonPoint;
/// [[x, y, z], [x, y, z]]: low and high corner; null for an empty box.
Json jsonBox(const model::Box& box);
/// The text; bytes that are no UTF-8 become U+FFFD.
std::string jsonText(const Json& json, int indent = -1);

}  // namespace sline::cli
