// SPDX-License-Identifier: Apache-2.0
// Makes names readable, and finds out what they say about sides.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/name_words.h"

namespace sline::model {

/// Makes a name of a file's stem: leading catalogue ids ("FJ3152_FMA16586_", "Model_51_", "VH_M_")
/// are dropped, underscores become spaces. A stem that is nothing but an id stays as it is.
std::string readableName(std::string_view stem);
/// Returns of a file's or folder's name, its ending aside, what may be shown to others
/// (model/anatomy/shown_names.h), made readable; empty where nothing is left.
std::string shownFileName(std::string_view stem);
/// Tells whether the whole name may be shown: it has none but known words and catalogue ids.
bool mayBeShown(std::string_view stem);
/// Treats a name given in a file like a stem; returns an empty name where a program only signs its
/// work ("Visualization Toolkit generated SLA File").
std::string nameInFile(std::string_view name);

/// Holds the side that a name says by a word of its own, in any of the languages of names ("left",
/// "r", "links", "sinistra"), and the name without it.
struct SidedName {
  Side side = Side::none;
  std::string rest;
};
SidedName sidedName(std::string_view name);

/// Gives later names equal to an earlier one (case ignored) a number: "rib", "rib 2", "rib 3".
void makeUnique(std::vector<std::string>& names);
/// Does the same for names that are shown. Where the number would be read as the thing's own it is
/// a counter (`withCounter`): where anatomy numbers such things ("rib (no. 2)"), and where words
/// were left out of any of the equal names (`cut`, by index), one of which may have been a number.
void tellApart(std::vector<std::string>& names, const std::vector<bool>& cut);

}  // namespace sline::model
