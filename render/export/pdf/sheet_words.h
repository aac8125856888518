// SPDX-License-Identifier: Apache-2.0
// Holds the words that a sheet has besides its contents, in the figure's language: English, German,
// Dutch, Norwegian or Latin.
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
  const char* sources;
};

/// Returns the words of a language; English for unknown ones.
const SheetWords& sheetWords(const std::string& language);

}  // namespace sline::render
