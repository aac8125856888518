// SPDX-License-Identifier: Apache-2.0
// Knows how large structures of a human body are, by the table in resources/anatomy (compiled in).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/name_patterns.h"
#include "model/base/units.h"

namespace sline::model {

class ExpectedSizes {
 public:
  /// Makes the program's own table.
  ExpectedSizes();
  /// Makes a table from rows as sizes.tsv describes them; rows that do not fit are left out and
  /// counted.
  explicit ExpectedSizes(std::string_view table);
  std::size_t badRows() const { return m_badRows; }

  /// Returns the least and the greatest extent, in millimetres, of a structure of that name, in any
  /// language that AnatomicalNames knows; nothing where the table does not have it.
  std::optional<Limits<float>> of(std::string_view name) const;

 private:
  bool add(const std::vector<std::string_view>& fields);

  AnatomicalNames m_names;
  NamePatterns m_patterns;  ///< the values are indices into `m_sizes`
  std::vector<Limits<float>> m_sizes;
  std::size_t m_badRows = 0;
};

}  // namespace sline::model
