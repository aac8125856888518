// SPDX-License-Identifier: Apache-2.0
// Names structures in several languages, by the table in resources/anatomy (compiled in).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/anatomy/name_rows.h"

namespace sline::model {

class AnatomicalNames {
 public:
  /// Reads the program's own table.
  AnatomicalNames();
  /// Reads a table in the format that names.tsv describes in its first lines; rows that do not fit
  /// are left out and counted.
  explicit AnatomicalNames(std::string_view table);

  std::size_t badRows() const { return m_table.badRows; }
  const std::vector<NameRow>& rows() const { return m_table.rows; }
  /// Returns the names that stand for two rows at once; an edit of the table must not create any.
  const std::vector<std::string>& ambiguities() const { return m_ambiguities; }

  /// Returns the name in that language, or the name itself where the table does not know it. Names
  /// are accepted as files have them, in any of the languages: "kidney_left", "Rib6", "L4", "linke
  /// Niere". Sides, numbers and trailing letters are kept; a capital at the beginning stays one.
  std::string displayName(std::string_view name, NameLanguage language) const;

  /// Tells whether the name's number is part of what the table calls the thing: "rib 2".
  bool isNumbered(std::string_view name) const {
    const std::optional<Found> found = find(name);
    return found && found->row->numbers;
  }
  /// Tells whether the table has the name in any language.
  bool knows(std::string_view name) const { return find(name).has_value(); }

  /// Returns the name itself and everything that the structure is called in any language, with
  /// sides.
  std::vector<std::string> searchWords(std::string_view name) const;

 private:
  struct Found {
    const NameRow* row = nullptr;
    Side side = Side::none;
    int number = 0;
    std::string tag;  ///< follows the name unchanged: " 2", " a", " L4–L5"
  };
  using Words = std::vector<std::string>;
  /// Maps the words of a name, in alphabetical order, to its row.
  using Index = std::unordered_map<std::string, std::size_t>;

  void fill(Words (*wordsOfName)(std::string_view), bool exact);
  void enter(const std::string& key, std::size_t row, bool exact);
  std::optional<Found> lookUp(const Words& words) const;
  std::optional<Found> lookUpSided(const Words& words) const;
  std::optional<Found> disc(const Words& words) const;
  std::optional<Found> find(std::string_view name) const;
  static std::string text(const Found& found, NameLanguage language);

  NameRows m_table;
  Index m_index;
  std::vector<std::string> m_ambiguities;
};

}  // namespace sline::model
