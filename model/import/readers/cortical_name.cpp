// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/cortical_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Returns runs of letters, in small ones.
std::vector<std::string> letterRuns(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (isUpper(c) || isLower(c))
      words.back() += lowerCase(c);
    else if (!words.back().empty())
      words.emplace_back();
  }
  return words;
}

bool hasOneOf(const std::vector<std::string>& words,
              std::initializer_list<std::string_view> known) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(known.begin(), known.end(), word) != known.end();
  });
}

struct CorticalSheet {
  std::string_view word;
  std::string_view name;
};
constexpr std::array<CorticalSheet, 10> sheets = {{{"pial", "pial surface"},
                                                   {"white", "white matter surface"},
                                                   {"graywhite", "white matter surface"},
                                                   {"wm", "white matter surface"},
                                                   {"smoothwm", "smoothed white matter surface"},
                                                   {"midthickness", "midthickness surface"},
                                                   {"graymid", "midthickness surface"},
                                                   {"orig", "first surface"},
                                                   {"inflated", "inflated surface"},
                                                   {"sphere", "spherical surface"}}};

}  // namespace

std::string corticalName(const std::filesystem::path& file, std::string_view more) {
  std::vector<std::string> words = letterRuns(file.filename().string());
  for (std::string& word : letterRuns(more))
    words.push_back(std::move(word));
  const bool left = hasOneOf(words, {"lh", "l", "left", "cortexleft"});
  const bool right = hasOneOf(words, {"rh", "r", "right", "cortexright"});
  if (left == right)
    return {};
  for (const CorticalSheet& sheet : sheets)
    if (hasOneOf(words, {sheet.word}))
      return (left ? "left " : "right ") + std::string(sheet.name);
  return {};
}

bool isCalledAnatomical(const std::filesystem::path& file) {
  const std::vector<std::string> words = letterRuns(file.filename().string());
  return std::none_of(words.begin(), words.end(), [](const std::string& word) {
    return word.ends_with("inflated") || word.ends_with("sphere") || word == "flat";
  });
}

}  // namespace sline::model
