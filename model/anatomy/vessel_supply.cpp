// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/vessel_supply.h"

#include <algorithm>

#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"

namespace sline::model {

namespace {

bool holdsAll(const std::vector<std::string>& words, const std::vector<std::string>& some) {
  return std::all_of(some.begin(), some.end(), [&words](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  });
}

}  // namespace

VesselSupply::VesselSupply() : VesselSupply(supplyText()) {}

VesselSupply::VesselSupply(std::string_view table) {
  for (const std::vector<std::string_view>& fields : tableRows(table)) {
    Row row;
    if (fields.size() == 2) {
      row.vessel = nameWords(fields[0]);
      for (const std::string_view served : cutAt(fields[1], '|'))
        row.served.push_back(nameWords(served));
    }
    const bool fits = !row.vessel.empty() && std::none_of(row.served.begin(), row.served.end(),
                                                          [](const Words& w) { return w.empty(); });
    if (fits)
      m_rows.push_back(std::move(row));
    else
      ++m_badRows;
  }
}

VesselSupply::Name VesselSupply::understood(std::string_view name) const {
  Name known;
  for (std::string& word : nameWords(m_names.displayName(name, NameLanguage::english)))
    if (const Side side = sideOfWord(word); side != Side::none)
      known.side = side;
    else
      known.words.push_back(std::move(word));
  return known;
}

bool VesselSupply::serves(const Name& vessel, const Name& structure) const {
  if (vessel.side != structure.side && vessel.side != Side::none && structure.side != Side::none)
    return false;
  return std::any_of(m_rows.begin(), m_rows.end(), [&](const Row& row) {
    return holdsAll(vessel.words, row.vessel) &&
           std::any_of(row.served.begin(), row.served.end(),
                       [&](const Words& served) { return holdsAll(structure.words, served); });
  });
}

}  // namespace sline::model
