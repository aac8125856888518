// SPDX-License-Identifier: Apache-2.0
// Holds what is said in several languages.
#pragma once

#include <map>
#include <string>

namespace sline::model {

struct Wording {
  std::string text;                          ///< in the language of the scene
  std::map<std::string, std::string> texts;  ///< in other languages, by BCP 47 tag ("la")

  bool empty() const { return text.empty() && texts.empty(); }
  /// Returns the text in the language, or the scene's own text where there is none.
  const std::string& in(const std::string& language) const {
    const auto found = texts.find(language);
    return found == texts.end() ? text : found->second;
  }
  /// Sets the text in the language, which is empty for the scene's own; one without words is
  /// removed.
  void set(const std::string& language, std::string words) {
    if (language.empty())
      text = std::move(words);
    else if (words.empty())
      texts.erase(language);
    else
      texts[language] = std::move(words);
  }
  bool operator==(const Wording&) const = default;
};

}  // namespace sline::model
