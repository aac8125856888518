// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/named_bodies.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "model/anatomy/kin_names.h"
#include "model/anatomy/shown_names.h"
#include "model/base/letters.h"
#include "model/import/kinds/entry_names.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/named_body.h"
#include "model/import/naming/names.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Holds what comes under one set of words that may be a person's.
struct NamedBody {
  std::set<std::string> organs;  ///< what the files' names may show
  std::vector<fs::path> files;
  std::size_t index = 0;
};

bool isWrittenLikeAName(const std::string& word) {
  return word.size() > 1 && isUpper(word.front()) &&
         std::none_of(word.begin() + 1, word.end(),
                      [](char c) { return isUpper(c) || isDigit(c); });
}

/// Finds the words of files' names and of their folders' that may be a person's. Numbers alone are
/// no one's name.
class OwnersWords {
 public:
  std::set<std::string> of(const SourceFile& file) {
    std::set<std::string> words = in(stemOf(file.file));
    add(words, file.file.parent_path().filename().string());
    for (const std::string& folder : file.folders)
      add(words, folder);
    return words;
  }

 private:
  static std::set<std::string> in(const std::string& name) {
    std::set<std::string> words;
    for (std::string& word : wordsNotShown(readableName(name)))
      if (!std::all_of(word.begin(), word.end(), isDigit))
        words.insert(std::move(word));
    return words;
  }
  void add(std::set<std::string>& words, const std::string& folder) {
    const auto [known, isNew] = m_folders.try_emplace(folder);
    if (isNew)
      known->second = in(folder);
    words.insert(known->second.begin(), known->second.end());
  }

  std::map<std::string, std::set<std::string>> m_folders;  ///< as many files lie in each
};

/// Tells whether the words may be a first name and a last one that stand before several organs, as
/// a person's do and a structure's own do not.
bool isWholeName(const std::vector<std::string>& words, const NamedBody& body) {
  constexpr std::size_t several = 2;
  std::set<std::string> organs;
  for (const std::string& organ : body.organs)
    organs.insert(kinName(organ).pair);
  return words.size() >= several && organs.size() >= several;
}

/// Tells whether two bodies have so much in common that they are two, or are of two persons.
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
  if (!names(ones) || !names(others))
    return twice >= surely;
  return twice > 0 || (isWholeName(ones, a) && isWholeName(others, b));
}

/// Returns the files by what names of them or of their folders, the nearest first, say of the body,
/// where they say different things; those of which nothing is said are of any.
std::vector<PatientFiles> bodiesSaid(const Sources& sources, const std::set<fs::path>& marked,
                                     std::string (*said)(std::string_view)) {
  std::vector<std::pair<std::string, PatientFiles>> bodies;
  for (const SourceFile& file : sources.files) {
    if (file.model || file.slice || marked.contains(file.file))
      continue;
    std::string of = said(stemOf(file.file));
    if (of.empty())
      of = said(file.file.parent_path().filename().string());
    for (auto folder = file.folders.rbegin(); folder != file.folders.rend() && of.empty(); ++folder)
      of = said(*folder);
    if (of.empty())
      continue;
    auto body = std::find_if(bodies.begin(), bodies.end(),
                             [&of](const auto& each) { return each.first == of; });
    if (body == bodies.end())
      body = bodies.insert(body, {of, {}});
    body->second.files.push_back(file.file);
  }
  std::vector<PatientFiles> apart;
  for (auto& [of, files] : bodies)
    if (bodies.size() > 1)
      apart.push_back(std::move(files));
  return apart;
}

}  // namespace

std::vector<PatientFiles> bodiesByName(const Sources& sources, const std::set<fs::path>& marked) {
  for (const auto said : {sexInName, numberInName})
    if (std::vector<PatientFiles> bodies = bodiesSaid(sources, marked, said); !bodies.empty())
      return bodies;
  using Bodies = std::map<std::set<std::string>, NamedBody>;
  Bodies bodies;
  OwnersWords owners;
  std::vector<Bodies::const_pointer> order;
  std::map<std::string, std::vector<std::size_t>> having;  ///< which bodies have an organ
  for (const SourceFile& file : sources.files) {
    if (file.model || file.slice || isEntryFile(file.file) || marked.contains(file.file))
      continue;
    const std::set<std::string> words = owners.of(file);
    if (words.empty())
      continue;
    const std::string organ = lowerCase(shownFileName(stemOf(file.file)));
    if (organ.empty())
      continue;
    const auto [body, isNew] = bodies.try_emplace(words);
    if (isNew) {
      body->second.index = order.size();
      order.push_back(&*body);
    }
    if (body->second.organs.insert(organ).second)
      having[organ].push_back(body->second.index);
    body->second.files.push_back(file.file);
  }
  // Whoever has organs that another has as well is one of several. What nearly everybody has is
  // what their makers call things.
  constexpr std::size_t mostPatients = 50;
  std::vector<bool> several(order.size());
  for (const auto& [organ, who] : having)
    for (std::size_t i = 0; i < who.size() && who.size() <= mostPatients; ++i)
      for (std::size_t k = i + 1; k < who.size(); ++k) {
        const auto& [one, a] = *order[who[i]];
        const auto& [other, b] = *order[who[k]];
        if (areTwo(one, a, other, b))
          several[who[i]] = several[who[k]] = true;
      }
  for (std::size_t i = 0; i < order.size() && order.size() <= mostPatients; ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k)
      if (areTwo(order[i]->first, order[i]->second, order[k]->first, order[k]->second))
        several[i] = several[k] = true;
  std::vector<PatientFiles> apart;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (several[i])
      apart.push_back({order[i]->second.files});
  return apart;
}

}  // namespace sline::model
