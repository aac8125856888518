// SPDX-License-Identifier: Apache-2.0
// Finds which of many runs of words fits a structure's name best.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

class NamePatterns {
 public:
  /// Adds a run of words; "=" in front: the whole name. `value` is what `match` returns for it.
  /// Returns false for a text without words.
  bool add(std::string_view text, std::size_t value, int rank = 0);
  std::size_t count() const { return m_count; }

  /// Returns the value of the pattern that fits the name best: highest rank, then most words, then
  /// most letters, then the one added first. A pattern with a rank counts more before "of" than
  /// behind it: the vein of a nucleus is a vein. What the name takes away does not count (see
  /// affirmedWords). Returns nothing where no pattern occurs in the
  /// name.
  std::optional<std::size_t> match(std::string_view name) const;

 private:
  struct Pattern {
    std::vector<std::string> words;
    std::size_t letters = 0;
    std::size_t value = 0;
    int rank = 0;
    bool wholeName = false;
  };
  std::map<std::string, std::vector<Pattern>, std::less<>> m_patterns;  ///< by their first word
  std::size_t m_count = 0;
};

}  // namespace sline::model
