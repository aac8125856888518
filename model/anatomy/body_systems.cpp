// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/body_systems.h"

#include <algorithm>
#include <tuple>

#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"
#include "model/base/colour_text.h"

namespace sline::model {

AnatomyTable::AnatomyTable() : AnatomyTable(anatomySystemsText(), anatomyStructuresText()) {}

AnatomyTable::AnatomyTable(std::string_view systems, std::string_view structures) {
  for (const std::vector<std::string_view>& fields : tableRows(systems))
    addSystem(fields);
  for (const std::vector<std::string_view>& fields : tableRows(structures))
    addPattern(fields);
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
  if (!m_patterns.add(fields[0], m_matches.size(), fields[3] == "1" ? 1 : 0)) {
    ++m_badRows;
    return;
  }
  m_names.emplace_back(fields[0].substr(fields[0].starts_with('=') ? 1 : 0));
  m_matches.push_back({std::size_t(owner - m_systems.data()), colour.value_or(owner->colour)});
}

std::vector<NamedColour> AnatomyTable::colours() const {
  std::vector<NamedColour> colours;
  for (std::size_t i = 0; i < m_systems.size(); ++i) {
    colours.push_back({m_systems[i].title, m_systems[i].colour, true});
    // Several patterns stand for one structure, such as its plural and its abbreviation.
    std::vector<Colour> had{m_systems[i].colour};
    for (std::size_t k = 0; k < m_matches.size(); ++k) {
      const Colour& colour = m_matches[k].colour;
      if (m_matches[k].system != i || std::find(had.begin(), had.end(), colour) != had.end())
        continue;
      had.push_back(colour);
      colours.push_back({m_names[k], colour, false});
    }
  }
  return colours;
}

std::optional<AnatomyMatch> AnatomyTable::match(std::string_view name) const {
  const std::optional<std::size_t> best = m_patterns.match(name);
  return best ? std::optional(m_matches[*best]) : std::nullopt;
}

}  // namespace sline::model
