// SPDX-License-Identifier: Apache-2.0
// Reads an entry in the categories of PDBx/mmCIF, row by row, from either of its notations: CIF
// (Hall, Allen & Brown, Acta Cryst. A47, 1991) and mmJSON (Protein Data Bank Japan). Rows are
// handed over as they are read, so that a large entry is in memory only once.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/import/source/source.h"

namespace sline::model {

struct EntryValue {
  std::string_view text = "?";  ///< without quotes
  bool quoted = false;          ///< so that '?' and '.' mean themselves

  /// Tells whether the value is neither unknown (?) nor inapplicable (.).
  bool says() const { return quoted || (text != "?" && text != "."); }
};

/// Names the items for which a category's rows have values.
struct EntryColumns {
  std::vector<std::string> names;  ///< in lower case: "_atom_site.cartn_x"

  bool areOf(std::string_view category) const {
    return !names.empty() && names.front().starts_with(category);
  }
  /// Returns the column that holds the item, or the one past the last where there is none.
  std::size_t column(std::string_view name) const;
};

/// Receives an entry's rows. The values that it is given live as long as the call.
class EntryRowReader {
 public:
  virtual ~EntryRowReader() = default;
  /// Takes one row, which has as many values as columns.
  virtual void readRow(const EntryColumns& columns, std::span<const EntryValue> values) = 0;
  /// Reports a table that ended in the middle of a row.
  virtual void missRow(const EntryColumns& columns) = 0;
  /// Is asked after each block of data; returns true where the next ones are not wanted.
  virtual bool hasEnough() const = 0;
};

/// Hands over all rows that can be read; the error says where the text stops being CIF.
Status readCifRows(const Source& source, EntryRowReader& reader);

/// Hands over the rows of mmJSON; nothing is handed over unless all of it can be read.
Status readMmjsonRows(const Source& source, EntryRowReader& reader);

}  // namespace sline::model
