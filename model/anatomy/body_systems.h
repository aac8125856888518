// SPDX-License-Identifier: Apache-2.0
// Derives from a structure's name its system and its conventional colour, by the table in
// resources/anatomy (compiled in).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/name_patterns.h"
#include "model/anatomy/tissue.h"
#include "model/base/units.h"

namespace sline::model {

struct AnatomySystem {
  std::string id;     ///< "artery"
  std::string title;  ///< "Arteries": the name of the system's group
  Colour colour;
  Tissue tissue = Tissue::unknown;
};

/// A colour with the name of what has it by convention.
struct NamedColour {
  std::string name;  ///< the title of a system, or a structure's name
  Colour colour;
  bool system = false;
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
  std::size_t patternCount() const { return m_patterns.count(); }
  std::size_t badRows() const { return m_badRows; }
  const AnatomySystem* system(std::string_view id) const;
  /// Returns the colours: each system's, followed by those of its structures that have others.
  std::vector<NamedColour> colours() const;

  /// Returns the row that fits the name best (see NamePatterns); nothing where none does.
  std::optional<AnatomyMatch> match(std::string_view name) const;

 private:
  void addSystem(const std::vector<std::string_view>& fields);
  void addPattern(const std::vector<std::string_view>& fields);

  std::vector<AnatomySystem> m_systems;
  NamePatterns m_patterns;  ///< the values are indices into `m_matches`
  std::vector<AnatomyMatch> m_matches;
  std::vector<std::string> m_names;  ///< of the patterns, as long as `m_matches`
  std::size_t m_badRows = 0;
};

}  // namespace sline::model
