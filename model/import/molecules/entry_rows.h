// SPDX-License-Identifier: Apache-2.0
// An entry in the categories of PDBx/mmCIF, row by row, from either of the notations it comes in:
// CIF (Hall, Allen & Brown, Acta Cryst. A47, 1991) and mmJSON (Protein Data Bank Japan). Rows are
// handed over as they are read, so that a large entry is in memory but once.
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

  /// It is neither unknown (?) nor inapplicable (.).
  bool says() const { return quoted || (text != "?" && text != "."); }
};

/// The items that a category's rows have values of.
struct EntryColumns {
  std::vector<std::string> names;  ///< in lower case: "_atom_site.cartn_x"

  bool areOf(std::string_view category) const {
    return !names.empty() && names.front().starts_with(category);
  }
  /// Which column holds the item; past the last where none does.
  std::size_t column(std::string_view name) const;
};

/// Whoever wants an entry's rows. What it is given lives as long as the call.
class EntryRowReader {
 public:
  virtual ~EntryRowReader() = default;
  /// As many values as columns.
  virtual void readRow(const EntryColumns& columns, std::span<const EntryValue> values) = 0;
  /// A table ended in the middle of a row.
  virtual void missRow(const EntryColumns& columns) = 0;
  /// Asked after each block of data; true where the next ones are not wanted.
  virtual bool hasEnough() const = 0;
};

/// Hands over what can be read; the error says where the text stops being CIF.
Status readCifRows(const Source& source, EntryRowReader& reader);

/// The same of mmJSON, of which nothing is handed over unless all of it can be read.
Status readMmjsonRows(const Source& source, EntryRowReader& reader);

}  // namespace sline::model
