// SPDX-License-Identifier: Apache-2.0
#include "app/cli/json_values.h"

#include "model/scene_file/json_value.h"

namespace sline::cli {

Json jsonNumber(float value) {
  return model::jsonNumber(value);
}

Json jsonPoint(const glm::vec3& p) {
  return Json::array({jsonNumber(p.x), jsonNumber(p.y), jsonNumber(p.z)});
}

Json jsonBox(const model::Box& box) {
  if (box.empty())
    return nullptr;
  return Json::array({jsonPoint(box.low), jsonPoint(box.high)});
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sline::cli
