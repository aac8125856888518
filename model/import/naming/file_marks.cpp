// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/file_marks.h"

#include <algorithm>
#include <cstdint>

#include "model/base/letters.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/molecules/elements.h"
#include "model/import/naming/names.h"

namespace sline::model {

namespace {

/// Returns the 64-bit checksum of Fowler, Noll and Vo (FNV-1a, RFC 9923) in hexadecimal digits.
std::string checksum(const std::string& text) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text)
    sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4)
    digits += "0123456789abcdef"[sum >> shift & 15];
  return digits;
}

}  // namespace

std::string fileMark(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  return name.empty() || mayBeShown(stemOf(file)) ? name : '#' + checksum(name);
}

std::string shownMoleculePart(const std::string& name) {
  constexpr std::string_view dash = " – ";
  const std::size_t at = name.find(dash);
  if (at != std::string::npos)
    return mayBeShown(name.substr(at + dash.size())) ? name : name.substr(0, at);
  const std::size_t open = name.rfind(" (");
  const std::size_t close = name.find(')', std::min(open, name.size()));
  if (close == std::string::npos || mayBeShown(name.substr(0, open)))
    return name;
  const std::string code = name.substr(open + 2, close - open - 2);
  const Element* element = elementOf(code.substr(0, code.find_first_of("0123456789")));
  constexpr std::size_t ending = 3;  // chlorine is chloride as an ion
  const bool ofElement =
      element && lowerCase(name).starts_with(element->name.substr(
                     0, element->name.size() - std::min(ending, element->name.size() - 1)));
  return ofElement ? name : code + name.substr(close + 1);
}

std::string partMark(const std::string& part) {
  return part.empty() || mayBeShown(part) ? part : '#' + checksum(part);
}

}  // namespace sline::model
