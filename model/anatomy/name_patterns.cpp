// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/name_patterns.h"

#include <algorithm>
#include <tuple>

#include "model/anatomy/name_words.h"

namespace sline::model {

bool NamePatterns::add(std::string_view text, std::size_t value, int rank) {
  Pattern pattern{
      .words = nameWords(text), .value = value, .rank = rank, .wholeName = text.starts_with('=')};
  if (pattern.words.empty())
    return false;
  for (const std::string& word : pattern.words)
    pattern.letters += word.size();
  m_patterns[pattern.words.front()].push_back(std::move(pattern));
  ++m_count;
  return true;
}

std::optional<std::size_t> NamePatterns::match(std::string_view name) const {
  const std::vector<std::string> words = nameWords(name);
  const Pattern* best = nullptr;
  const auto merit = [](const Pattern& p) {
    return std::tuple(p.rank, p.wholeName, p.words.size(), p.letters);
  };
  for (std::size_t at = 0; at < words.size(); ++at) {
    const auto found = m_patterns.find(words[at]);
    if (found == m_patterns.end())
      continue;
    for (const Pattern& pattern : found->second) {
      if (at + pattern.words.size() > words.size() ||
          (pattern.wholeName && pattern.words.size() != words.size()) ||
          !std::equal(pattern.words.begin(), pattern.words.end(), words.begin() + at))
        continue;
      if (!best || merit(pattern) > merit(*best))
        best = &pattern;
    }
  }
  return best ? std::optional(best->value) : std::nullopt;
}

}  // namespace sline::model
