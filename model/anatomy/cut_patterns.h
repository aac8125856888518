// SPDX-License-Identifier: Apache-2.0
// Derives from a structure's name how its cut face is drawn, by the table in
// resources/anatomy/tissue_patterns.tsv (compiled in).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/cut_pattern.h"
#include "model/anatomy/name_patterns.h"

namespace sline::model {

class CutPatternTable {
 public:
  /// Makes the program's own table.
  CutPatternTable();
  /// Makes a table from a text of tab-separated rows as described in its first lines; rows that do
  /// not fit are left out and counted.
  explicit CutPatternTable(std::string_view text);

  std::size_t badRows() const { return m_badRows; }
  /// Returns whether the table has a row for the tissue, whatever the name.
  bool covers(Tissue tissue) const;

  /// Returns the pattern of a structure of that name; nothing where the name says no system.
  std::optional<CutPattern> match(std::string_view name) const;

 private:
  struct Rows {
    NamePatterns named;  ///< the values are those of CutPattern
    std::optional<CutPattern> others;
  };
  void addRow(std::string_view of, std::string_view words, std::string_view pattern);

  AnatomyTable m_anatomy;
  std::map<std::string, Rows, std::less<>> m_rows;  ///< by tissue or system
  std::size_t m_badRows = 0;
};

}  // namespace sline::model
