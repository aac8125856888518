// SPDX-License-Identifier: Apache-2.0
// What stands on a sheet besides its contents, in the figure's language: English, German, Dutch,
// Norwegian or Latin.
#pragma once

#include <string>

namespace sline::render {

/// UTF-8.
struct SheetWords {
  const char* language;
  const char* legend;
  const char* labels;
  const char* continued;
  const char* selfTest;
  const char* key;
  const char* name;
  const char* date;
};

/// English for languages that are not known.
const SheetWords& sheetWords(const std::string& language);

}  // namespace sline::render
