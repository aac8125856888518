// SPDX-License-Identifier: Apache-2.0
// The rows of resources/anatomy/names.tsv.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/laterality_words.h"

namespace sline::model {

/// The numbers that a name may have: vertebrae T1 to T12.
struct NumberRange {
  int first = 0;
  int last = 0;
  bool roman = false;  ///< how English and the languages without a rule of their own write them
  bool holds(int number) const { return number >= first && number <= last; }
  bool operator==(const NumberRange&) const = default;
};

struct NameRow {
  /// By NameLanguage, # and @ where a number goes.
  std::array<std::string, nameLanguages> names;
  Agreement latin;
  Agreement german;
  std::optional<NumberRange> numbers;
  std::vector<std::string> synonyms;

  Agreement agreement(NameLanguage language) const;
};

struct NameRows {
  std::vector<NameRow> rows;
  std::size_t badRows = 0;  ///< left out because something is missing in them
};
/// Of the table's text.
NameRows readNameRows(std::string_view text);

/// "IV", for 1 to 39.
std::string romanNumeral(int number);
/// The other way round, in lower case; 0 for what is none.
int fromRoman(std::string_view text);
/// # and @ become the number in digits and in Roman numerals.
std::string withNumber(const std::string& name, int number);

}  // namespace sline::model
