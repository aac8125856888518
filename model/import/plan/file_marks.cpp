// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/file_marks.h"

#include <algorithm>
#include <cstdint>

#include "model/base/letters.h"
#include "model/import/kinds/file_kinds.h"
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

bool isEntryFile(const std::filesystem::path& file) {
  const std::string stem = stemOf(file);
  const std::string id = stem.substr(0, stem.find("-assembly"));
  constexpr std::size_t length = 4;  // a digit, then letters and digits
  return id.size() == length && isDigit(id.front()) &&
         std::all_of(id.begin(), id.end(), [](char c) { return isDigit(c) || isLetter(c); }) &&
         std::any_of(id.begin(), id.end(), isLetter);
}

std::string partMark(const std::string& part) {
  return part.empty() || mayBeShown(part) ? part : '#' + checksum(part);
}

}  // namespace sline::model
