// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/name_words.h"

#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Returns UTF-8 text in lower case: ASCII and the letters of Western Europe (À to Þ, which follow
/// the byte C3).
std::string lowerCaseOfUtf8(std::string text) {
  char before = 0;
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (isUpper(c))
      c = lowerCase(c);
    else if (before == '\xc3' && byte >= 0x80 && byte <= 0x9e && byte != 0x97)
      c = char(byte + 0x20);
    before = c;
  }
  return text;
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty())
      words.push_back(lowerCaseOfUtf8(word));
    word.clear();
  };
  for (const char c : name) {
    if (!isLetter(c) && !isDigit(c)) {
      finish();
      continue;
    }
    if (!word.empty()) {
      const char last = word.back();
      // "kidneyCyst" and "Rib6" hold two words each; "L5" and "T12" hold one.
      if ((isLower(last) && isUpper(c)) || (isDigit(c) && isLetter(last) && word.size() > 1))
        finish();
    }
    word += c;
  }
  finish();
  return words;
}

std::vector<std::string> nameWords(std::string_view name) {
  std::vector<std::string> words = wordsOf(name);
  for (std::string& word : words)
    word = singular(std::move(word));
  return words;
}

std::string singular(std::string word) {
  if (word == "disk" || word == "disks" || word == "discs")
    return "disc";
  if (word == "vertebrae")
    return "vertebra";
  if (word == "calyces" || word == "calices")
    return "calyx";
  if (word == "bronchi")
    return "bronchus";
  if (word == "metastases")
    return "metastasis";
  if (word == "nuclei")
    return "nucleus";
  if (word == "ganglia")
    return "ganglion";
  if (word.size() > 4 && word.ends_with("ies"))
    return word.substr(0, word.size() - 3) + "y";
  const bool latin = word.ends_with("ss") || word.ends_with("us") || word.ends_with("is") ||
                     word.ends_with("ps") || word.ends_with("as");
  if (word.size() > 3 && word.ends_with('s') && !latin)
    word.pop_back();
  return word;
}

}  // namespace sline::model
