// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/names.h"

#include <algorithm>

namespace sline::cli {

Error unknownName(std::string_view what, std::string_view name,
                  std::span<const std::string> names) {
  std::string remedy = model::nearNamesText(name, names);
  if (remedy.empty())
    remedy = "`sline info` lists the names";
  return Error{.reason = "no " + std::string(what) + " is named \"" + std::string(name) + "\"",
               .remedy = remedy};
}

Result<std::vector<model::NodeId>> nodesNamed(const model::Scene& scene, std::string_view name) {
  std::vector<model::NodeId> ids = scene.named(name);
  if (!ids.empty())
    return ids;
  std::vector<std::string> names;
  for (const model::Node& node : scene.nodes())
    names.push_back(node.name);
  return unknownName("structure or group", name, names);
}

std::string onOneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
  return text;
}

}  // namespace sline::cli
