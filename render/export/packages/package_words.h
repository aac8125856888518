// SPDX-License-Identifier: Apache-2.0
// Holds the words that questions for learning systems have besides names, in the figure's language:
// English, German, Dutch, Norwegian or Latin.
#pragma once

#include <string>

namespace sline::render {

/// Words in UTF-8; "%1" stands for a name.
struct PackageWords {
  const char* language;
  const char* questions;    ///< heads the questions of a scene without a name
  const char* find;         ///< to click where something is
  const char* putMarker;    ///< to drag a marker there
  const char* nameIt;       ///< to type a name
  const char* chooseIt;     ///< to choose one
  const char* whichNumber;  ///< to choose the number of something
  const char* right;
  const char* wrong;
  const char* missed;  ///< nothing was hit that can be
  const char* check;
  const char* again;
  const char* solution;
};

/// Returns the words of a language; English for unknown ones.
const PackageWords& packageWords(const std::string& language);

/// Returns the words with the name in its place.
std::string withName(const char* words, const std::string& name);

}  // namespace sline::render
