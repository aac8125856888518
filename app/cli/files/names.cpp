// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/names.h"

#include <algorithm>
#include <set>

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

/// Returns "Miller / left kidney": the name behind the groups that hold the structure.
std::string pathOf(const model::Scene& scene, model::NodeId id) {
  const std::string groups = scene.groupPath(id);
  const std::string& name = scene.find(id)->name;
  return groups.empty() ? name : groups + " / " + name;
}

std::vector<model::NodeId> ofPath(const model::Scene& scene, std::string_view path) {
  const std::string wanted = model::normalisedName(path);
  std::vector<model::NodeId> ids;
  if (path.find('/') != std::string_view::npos)
    for (const model::Node& node : scene.nodes())
      if (model::normalisedName(pathOf(scene, node.id)) == wanted)
        ids.push_back(node.id);
  return ids;
}

}  // namespace

Error ambiguousName(const model::Scene& scene, std::string_view name,
                    std::span<const model::NodeId> ids) {
  constexpr std::size_t shown = 8;
  std::string paths;
  std::set<std::string> different;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string path = onOneLine(pathOf(scene, ids[i]));
    different.insert(path);
    if (i < shown)
      paths += (i == 0 ? "\"" : ", \"") + path + '"';
  }
  return {.reason = "\"" + std::string(name) + "\" names " + std::to_string(ids.size()) +
                    " structures, and one is meant: " + paths + (ids.size() > shown ? ", …" : ""),
          .remedy = different.size() == ids.size() ? "Name one of them as it stands there"
                                                   : "Give them different names first"};
}

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
  if (ids.empty())
    ids = ofPath(scene, name);
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
