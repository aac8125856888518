// SPDX-License-Identifier: Apache-2.0
// Values of a scene as glTF's JSON has them.
#pragma once

#include <glm/mat3x3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/units.h"

namespace sline::render {

/// Keys keep their order, so that the same scene gives the same bytes.
using Json = nlohmann::ordered_json;

inline constexpr float metresPerMillimetre = 0.001f;

/// LPS → glTF's frame, +y up and the front of what is shown towards +z (glTF 2.0 §3.4): the
/// patient's left stays +x, so it is a quarter turn about x.
glm::dmat3 uprightFromLps();

/// The number with no more digits than a float needs. The value must be finite.
Json jsonNumber(float value);
Json jsonPoint(const glm::vec3& p);
/// The sRGB transfer function undone (IEC 61966-2-1): factors in glTF are linear.
double linearLight(std::uint8_t srgb);
/// The document's text; bytes that are no UTF-8 become U+FFFD.
std::string jsonText(const Json& json);

}  // namespace sline::render
