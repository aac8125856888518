// SPDX-License-Identifier: Apache-2.0
#include "model/scene/near_names.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/scene/scene.h"

namespace sline::model {

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
  const std::string normal = normalisedName(wanted);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    const std::string candidate = normalisedName(name);
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

std::string nearNamesText(std::string_view wanted, std::span<const std::string> names) {
  std::string text;
  for (const std::string& near : nearNames(wanted, names))
    text += (text.empty() ? "Near it: \"" : ", \"") + near + "\"";
  return text;
}

}  // namespace sline::model
