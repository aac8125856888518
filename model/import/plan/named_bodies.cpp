// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/named_bodies.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "model/anatomy/shown_names.h"
#include "model/base/letters.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/names.h"
#include "model/import/plan/file_marks.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Holds what comes under one set of words that may be a person's.
struct NamedBody {
  std::set<std::string> organs;  ///< what the files' names may show
  std::vector<fs::path> files;
};

bool isWrittenLikeAName(const std::string& word) {
  return word.size() > 1 && isUpper(word.front()) &&
         std::none_of(word.begin() + 1, word.end(),
                      [](char c) { return isUpper(c) || isDigit(c); });
}

/// Returns the words of the file's name and of its folders' that may be a person's.
std::set<std::string> ownersWords(const SourceFile& file) {
  std::set<std::string> words;
  const auto take = [&words](const std::string& name) {
    for (std::string& word : wordsNotShown(readableName(name)))
      words.insert(std::move(word));
  };
  take(stemOf(file.file));
  take(file.file.parent_path().filename().string());
  for (const std::string& folder : file.folders)
    take(folder);
  return words;
}

/// Tells whether two bodies have so much in common that they are two.
bool areTwo(const std::set<std::string>& one, const NamedBody& a,
            const std::set<std::string>& other, const NamedBody& b) {
  constexpr std::ptrdiff_t surely = 2;
  const auto twice =
      std::count_if(a.organs.begin(), a.organs.end(),
                    [&b](const std::string& organ) { return b.organs.contains(organ); });
  std::vector<std::string> ones;
  std::vector<std::string> others;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(ones));
  std::set_difference(other.begin(), other.end(), one.begin(), one.end(),
                      std::back_inserter(others));
  // Where only one has words, it may be a version.
  if (ones.empty() || others.empty())
    return false;
  const auto names = [](const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(), isWrittenLikeAName);
  };
  return twice >= surely || (twice > 0 && names(ones) && names(others));
}

}  // namespace

std::vector<PatientFiles> bodiesByName(const Sources& sources, const std::set<fs::path>& marked) {
  std::map<std::set<std::string>, NamedBody> bodies;
  std::vector<const std::set<std::string>*> order;
  for (const SourceFile& file : sources.files) {
    if (file.model || file.slice || isEntryFile(file.file) || marked.contains(file.file))
      continue;
    const std::string organ = lowerCase(shownFileName(stemOf(file.file)));
    const std::set<std::string> words = ownersWords(file);
    if (organ.empty() || words.empty())
      continue;
    const auto [body, isNew] = bodies.try_emplace(words);
    if (isNew)
      order.push_back(&body->first);
    body->second.organs.insert(organ);
    body->second.files.push_back(file.file);
  }
  // Whoever has organs that another has as well is one of several.
  std::vector<PatientFiles> apart;
  for (const std::set<std::string>* one : order) {
    const auto isOther = [&](const std::set<std::string>* other) {
      return other != one && areTwo(*one, bodies.at(*one), *other, bodies.at(*other));
    };
    if (std::any_of(order.begin(), order.end(), isOther))
      apart.push_back({bodies.at(*one).files});
  }
  return apart;
}

}  // namespace sline::model
