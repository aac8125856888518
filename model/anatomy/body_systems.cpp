// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/body_systems.h"

#include <algorithm>
#include <charconv>
#include <tuple>

#include "model/anatomy/name_words.h"
#include "model/anatomy/systems_table.h"
#include "model/base/colour_text.h"

namespace sline::model {

namespace {

template <class Row>
void forEachRow(std::string_view text, const Row& row) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    if (line.empty() || line.front() == '#')
      continue;
    std::vector<std::string_view> fields;
    while (true) {
      const std::size_t tab = line.find('\t');
      fields.push_back(line.substr(0, tab));
      if (tab == std::string_view::npos)
        break;
      line.remove_prefix(tab + 1);
    }
    row(fields);
  }
}

}  // namespace

AnatomyTable::AnatomyTable() : AnatomyTable(anatomySystemsText(), anatomyStructuresText()) {}

AnatomyTable::AnatomyTable(std::string_view systems, std::string_view structures) {
  forEachRow(systems, [this](const auto& fields) { addSystem(fields); });
  forEachRow(structures, [this](const auto& fields) { addPattern(fields); });
}

const AnatomySystem* AnatomyTable::system(std::string_view id) const {
  const auto found = std::find_if(m_systems.begin(), m_systems.end(),
                                  [id](const AnatomySystem& s) { return s.id == id; });
  return found == m_systems.end() ? nullptr : &*found;
}

void AnatomyTable::addSystem(const std::vector<std::string_view>& fields) {
  const auto colour = fields.size() == 4 ? colourFrom(fields[2]) : std::nullopt;
  const auto tissue = colour ? tissueNamed(fields[3]) : std::nullopt;
  if (!tissue)
    ++m_badRows;
  else
    m_systems.push_back({std::string(fields[0]), std::string(fields[1]), *colour, *tissue});
}

void AnatomyTable::addPattern(const std::vector<std::string_view>& fields) {
  const AnatomySystem* owner = fields.size() == 4 ? system(fields[1]) : nullptr;
  const auto colour = owner && !fields[2].empty() ? colourFrom(fields[2]) : std::nullopt;
  if (!owner || (!fields[2].empty() && !colour) || (fields[3] != "0" && fields[3] != "1")) {
    ++m_badRows;
    return;
  }
  Pattern pattern;
  pattern.wholeName = fields[0].starts_with('=');
  pattern.words = nameWords(fields[0]);
  if (pattern.words.empty()) {
    ++m_badRows;
    return;
  }
  for (const std::string& word : pattern.words)
    pattern.letters += word.size();
  pattern.match = {std::size_t(owner - m_systems.data()), colour.value_or(owner->colour)};
  pattern.rank = fields[3] == "1" ? 1 : 0;
  m_patterns[pattern.words.front()].push_back(std::move(pattern));
  ++m_patternCount;
}

std::optional<AnatomyMatch> AnatomyTable::match(std::string_view name) const {
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
  return best ? std::optional(best->match) : std::nullopt;
}

}  // namespace sline::model
