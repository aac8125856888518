// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/names.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sline::cli {

namespace {

/// Returns Levenshtein's distance: the fewest insertions, deletions and replacements of single
/// characters.
std::size_t typingErrors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string> nearNames(std::string_view wanted, std::span<const std::string> names) {
  constexpr std::size_t most = 5;
  const std::string normal = model::normalisedName(wanted);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    const std::string candidate = model::normalisedName(name);
    const bool contains = !normal.empty() && !candidate.empty() &&
                          (candidate.find(normal) != std::string::npos ||
                           normal.find(candidate) != std::string::npos);
    const std::size_t errors = typingErrors(normal, candidate);
    if (contains)
      ranked.emplace_back(0, name);
    else if (errors <= std::max<std::size_t>(2, normal.size() / 3))
      ranked.emplace_back(errors, name);
  }
  std::sort(ranked.begin(), ranked.end());
  ranked.erase(std::unique(ranked.begin(), ranked.end()), ranked.end());
  std::vector<std::string> near;
  for (const auto& [rank, name] : ranked)
    if (near.size() < most)
      near.push_back(name);
  return near;
}

Error unknownName(std::string_view what, std::string_view name,
                  std::span<const std::string> names) {
  std::string remedy;
  const std::vector<std::string> near = nearNames(name, names);
  for (const std::string& candidate : near)
    remedy += (remedy.empty() ? "Near it: \"" : ", \"") + candidate + "\"";
  if (near.empty())
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
