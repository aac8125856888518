// SPDX-License-Identifier: Apache-2.0
// Derives from a structure's name its system and its conventional colour, by the table in
// resources/anatomy (compiled in).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/tissue.h"
#include "model/base/units.h"

namespace sline::model {

struct AnatomySystem {
  std::string id;     ///< "artery"
  std::string title;  ///< "Arteries": the name of the system's group
  Colour colour;
  Tissue tissue = Tissue::unknown;
};

struct AnatomyMatch {
  std::size_t system = 0;  ///< in AnatomyTable::systems()
  Colour colour;
};

class AnatomyTable {
 public:
  /// Makes the program's own table.
  AnatomyTable();
  /// Makes a table from two texts of tab-separated rows as described in their first lines; rows
  /// that do not fit are left out and counted.
  AnatomyTable(std::string_view systems, std::string_view structures);

  const std::vector<AnatomySystem>& systems() const { return m_systems; }
  std::size_t patternCount() const { return m_patternCount; }
  std::size_t badRows() const { return m_badRows; }
  const AnatomySystem* system(std::string_view id) const;

  /// Returns the row that fits the name best: highest rank, then most words, then most letters,
  /// then the one named first. Returns nothing where no pattern occurs in the name.
  std::optional<AnatomyMatch> match(std::string_view name) const;

 private:
  struct Pattern {
    std::vector<std::string> words;
    std::size_t letters = 0;
    AnatomyMatch match;
    int rank = 0;
    bool wholeName = false;
  };
  void addSystem(const std::vector<std::string_view>& fields);
  void addPattern(const std::vector<std::string_view>& fields);

  std::vector<AnatomySystem> m_systems;
  std::map<std::string, std::vector<Pattern>, std::less<>> m_patterns;  ///< by their first word
  std::size_t m_patternCount = 0;
  std::size_t m_badRows = 0;
};

}  // namespace sline::model
