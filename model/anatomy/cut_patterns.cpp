// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/cut_patterns.h"

#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"

namespace sline::model {

CutPatternTable::CutPatternTable() : CutPatternTable(tissuePatternsText()) {}

CutPatternTable::CutPatternTable(std::string_view text) {
  for (const std::vector<std::string_view>& fields : tableRows(text)) {
    if (fields.size() == 3)
      addRow(fields[0], fields[1], fields[2]);
    else
      ++m_badRows;
  }
}

void CutPatternTable::addRow(std::string_view of, std::string_view words,
                             std::string_view pattern) {
  const auto drawn = cutPatternNamed(pattern);
  if (!drawn || (!tissueNamed(of) && !m_anatomy.system(of))) {
    ++m_badRows;
    return;
  }
  Rows& rows = m_rows[std::string(of)];
  if (!words.empty())
    m_badRows += rows.named.add(words, std::size_t(*drawn)) ? 0 : 1;
  else if (rows.others)
    ++m_badRows;
  else
    rows.others = drawn;
}

bool CutPatternTable::covers(Tissue tissue) const {
  const auto found = m_rows.find(tissueNames[std::size_t(tissue)]);
  return found != m_rows.end() && found->second.others;
}

std::optional<CutPattern> CutPatternTable::match(std::string_view name) const {
  const std::optional<AnatomyMatch> match = m_anatomy.match(name);
  if (!match)
    return std::nullopt;
  const AnatomySystem& system = m_anatomy.systems()[match->system];
  std::optional<CutPattern> others;
  for (const std::string_view of :
       {std::string_view(system.id), tissueNames[std::size_t(system.tissue)]}) {
    const auto found = m_rows.find(of);
    if (found == m_rows.end())
      continue;
    if (const auto value = found->second.named.match(name))
      return CutPattern(*value);
    if (!others)
      others = found->second.others;
  }
  return others;
}

}  // namespace sline::model
