// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "model/geometry/mesh.h"

namespace sline::cli {

using Json = nlohmann::ordered_json;

/// The number with no more digits than a float needs, so that 0.1f is written 0.1. The value must
/// be finite.
Json jsonNumber(float value);
/// [x, y, z]
Json jsonPoint(const glm::vec3& p);
/// [[x, y, z], [x, y, z]]: low and high corner; null for an empty box.
Json jsonBox(const model::Box& box);
/// The text; bytes that are no UTF-8 become U+FFFD.
std::string jsonText(const Json& json, int indent = -1);

}  // namespace sline::cli
