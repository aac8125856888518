// SPDX-License-Identifier: Apache-2.0
// Words of descriptions in English, German, Dutch, Norwegian and Latin. Names of structures stand
// in them as they are in lists, so that no language has to bend them.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <string>
#include <vector>

#include "model/camera/camera.h"

namespace sline::render {

/// Sides are in the order of model::AnatomicalView; %1 and %2 are numbers, names or lists.
struct DescriptionTable {
  const char* language;
  const char* empty;
  const char* one;
  const char* many;
  std::array<const char*, 6> from;
  const char* seen;
  const char* labelled;
  std::array<const char*, 6> ends;
  const char* onLeft;
  const char* onTop;
  const char* inDoubt;               ///< where nobody knows which side is which
  std::array<const char*, 3> zones;  ///< what stands left, in the middle and right in the picture
  const char* names;                 ///< where all stand in one zone
  const char* before;
  const char* shown;  ///< where nothing is labelled
  const char* others;
  const char* more;
  const char* conjunction;
  const char* film;
};

/// Returns the table of the language, by its BCP 47 tag; English for others.
const DescriptionTable& descriptionTable(const std::string& language);

/// Returns "a, b and c" in the language.
QString listed(const QStringList& names, const DescriptionTable& table);
/// Returns the number of words: what blanks part.
std::size_t wordCount(const QString& text);

}  // namespace sline::render
