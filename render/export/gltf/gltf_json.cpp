// SPDX-License-Identifier: Apache-2.0
#include "render/export/gltf/gltf_json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "model/base/srgb.h"

namespace sline::render {

glm::dmat3 uprightFromLps() {
  // The columns are where x, y and z of LPS go.
  return {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
}

Json jsonNumber(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double shortest = 0.0;
  std::from_chars(text.data(), end, shortest);
  return shortest;
}

Json jsonPoint(const glm::vec3& p) {
  return Json::array({jsonNumber(p.x), jsonNumber(p.y), jsonNumber(p.z)});
}

double linearLight(std::uint8_t srgb) {
  return lightFromSrgb(double(srgb) / 255.0);
}

std::string jsonText(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sline::render
