// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/json_values.h"

namespace sline::cli {

Json jsonBox(const model::Box& box) {
  if (box.empty())
    return nullptr;
  return Json::array({jsonPoint(box.low), jsonPoint(box.high)});
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sline::cli
