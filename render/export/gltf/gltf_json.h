// SPDX-License-Identifier: Apache-2.0
// Converts values of a scene to glTF's JSON.
#pragma once

#include <glm/mat3x3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/units.h"

namespace sline::render {

/// A JSON value with keys in order, so that the same scene gives the same bytes.
using Json = nlohmann::ordered_json;

inline constexpr float metresPerMillimetre = 0.001f;

/// Returns the turn from LPS to glTF's frame, with +y up and the front of what is shown towards +z
/// (glTF 2.0 §3.4): the patient's left stays +x, so it is a quarter turn about x.
glm::dmat3 uprightFromLps();

/// Returns the number with no more digits than a float needs. The value must be finite.
Json jsonNumber(float value);
Json jsonPoint(const glm::vec3& p);
/// Undoes the sRGB transfer function (IEC 61966-2-1), as factors in glTF are linear.
double linearLight(std::uint8_t srgb);
/// Returns the document's text; bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const Json& json);

}  // namespace sline::render
