// SPDX-License-Identifier: Apache-2.0
// Holds the words that sheets, slides and cards have besides their contents, in the figure's
// language: English, German, Dutch, Norwegian or Latin.
#pragma once

#include <string>

namespace sline::render {

/// Words in UTF-8.
struct SheetWords {
  const char* language;
  const char* legend;
  const char* hiddenOutline;
  const char* labels;
  const char* continued;
  const char* selfTest;
  const char* key;
  const char* name;
  const char* date;
  const char* contents;
  const char* index;
  const char* wordBank;
  const char* writeNames;       ///< what a self-test wants
  const char* chooseNames;      ///< likewise, where there is a word bank
  const char* whatIsMarked;     ///< what a card asks beside a mark
  const char* whatIsHidden;     ///< likewise, beside a covered name
  const char* whichNumber;      ///< likewise, after the name of something that has a number
  const char* sources;          ///< heads the list of whose work the surfaces are
  const char* otherStructures;  ///< heads what is in no group, behind the groups
};

/// Returns the words of a language; English for unknown ones.
const SheetWords& sheetWords(const std::string& language);

}  // namespace sline::render
