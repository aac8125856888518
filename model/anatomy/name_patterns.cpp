// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/name_patterns.h"

#include <algorithm>
#include <tuple>

#include "model/anatomy/name_words.h"

namespace sline::model {

namespace {

/// Returns where the words end that say what a thing is, rather than of what: before "of".
std::size_t endOfHead(const std::vector<std::string>& words) {
  const auto of =
      std::find(words.begin() + std::min<std::ptrdiff_t>(1, std::ssize(words)), words.end(), "of");
  return std::size_t(of - words.begin());
}

}  // namespace

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
  const std::vector<std::string> words = affirmedWords(name);
  const std::size_t headEnd = endOfHead(words);
  using Merit = std::tuple<int, bool, std::size_t, std::size_t>;
  const Pattern* best = nullptr;
  Merit bestMerit;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const auto found = m_patterns.find(words[at]);
    if (found == m_patterns.end())
      continue;
    for (const Pattern& pattern : found->second) {
      if (at + pattern.words.size() > words.size() ||
          (pattern.wholeName && pattern.words.size() != words.size()) ||
          !std::equal(pattern.words.begin(), pattern.words.end(), words.begin() + at))
        continue;
      const bool decides = pattern.rank > 0 && at + pattern.words.size() <= headEnd;
      const Merit merit(pattern.rank + (decides ? 1 : 0), pattern.wholeName, pattern.words.size(),
                        pattern.letters);
      if (best && merit <= bestMerit)
        continue;
      best = &pattern;
      bestMerit = merit;
    }
  }
  return best ? std::optional(best->value) : std::nullopt;
}

}  // namespace sline::model
