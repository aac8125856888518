// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/names.h"

#include <algorithm>

#include "model/anatomy/anatomical_names.h"

namespace sline::cli {

namespace {

/// Returns what anatomists call that name in another way: "bladder" is the urinary bladder, "linke
/// Niere" the left kidney.
std::vector<model::NodeId> alsoCalled(const model::Scene& scene, std::string_view name) {
  static const model::AnatomicalNames table;
  std::vector<model::NodeId> ids;
  if (!table.knows(name))
    return ids;
  const auto called = [](std::string_view one) {
    return model::normalisedName(table.displayName(one, model::NameLanguage::english));
  };
  const std::string wanted = called(name);
  for (const model::Node& node : scene.nodes())
    if (table.knows(node.name) && called(node.name) == wanted)
      ids.push_back(node.id);
  return ids;
}

}  // namespace

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
  if (ids.empty())
    ids = alsoCalled(scene, name);
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
