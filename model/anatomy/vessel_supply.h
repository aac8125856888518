// SPDX-License-Identifier: Apache-2.0
// Knows from their names what vessels feed or drain, by the table in resources/anatomy (compiled
// in).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/anatomical_names.h"

namespace sline::model {

class VesselSupply {
 public:
  /// Makes the program's own table.
  VesselSupply();
  /// Makes a table from rows as supply.tsv describes them; rows that do not fit are left out and
  /// counted.
  explicit VesselSupply(std::string_view table);
  std::size_t badRows() const { return m_badRows; }

  /// Holds a name, understood once for many questions.
  struct Name {
    std::vector<std::string> words;  ///< of the English name, sides aside
    Side side = Side::none;
  };
  /// Understands names in all languages that AnatomicalNames knows.
  Name understood(std::string_view name) const;
  /// Tells whether a vessel of that name serves that structure: the right renal artery serves the
  /// right kidney, and a kidney whose name has no side.
  bool serves(const Name& vessel, const Name& structure) const;

 private:
  using Words = std::vector<std::string>;
  struct Row {
    Words vessel;
    std::vector<Words> served;
  };

  AnatomicalNames m_names;
  std::vector<Row> m_rows;
  std::size_t m_badRows = 0;
};

}  // namespace sline::model
