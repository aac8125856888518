// SPDX-License-Identifier: Apache-2.0
// Reads the rows of resources/anatomy/names.tsv.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/laterality_words.h"

namespace sline::model {

/// Holds the range of numbers that a name may have: vertebrae T1 to T12.
struct NumberRange {
  int first = 0;
  int last = 0;
  bool roman = false;  ///< whether English and languages without their own rule use Roman numerals
  bool holds(int number) const { return number >= first && number <= last; }
  bool operator==(const NumberRange&) const = default;
};

struct NameRow {
  /// The names by NameLanguage, with # and @ where a number goes.
  std::array<std::string, nameLanguages> names;
  Agreement latin;
  Agreement german;
  std::optional<NumberRange> numbers;
  std::vector<std::string> synonyms;

  Agreement agreement(NameLanguage language) const;
};

struct NameRows {
  std::vector<NameRow> rows;
  std::size_t badRows = 0;  ///< left out because a part of them is missing
};
/// Returns the rows of the table's text.
NameRows readNameRows(std::string_view text);

/// Returns the Roman numeral ("IV") of a number from 1 to 39.
std::string romanNumeral(int number);
/// Returns the number of a Roman numeral in lower case, or 0 where the text is not one.
int fromRoman(std::string_view text);
/// Returns the name with the number in digits for # and in Roman numerals for @.
std::string withNumber(const std::string& name, int number);

}  // namespace sline::model
