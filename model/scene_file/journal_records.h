// SPDX-License-Identifier: Apache-2.0
// Frames pieces of bytes so that a file to which they were appended can be read whatever its end
// looks like: each has its length and checksum before it, and the first that is not whole ends it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sline::model {

/// Begins each file of records.
inline constexpr std::string_view journalMagic = "sline journal 1\n";

/// Returns the record: length and CRC-32 of the payload, four bytes each, the lowest first, and the
/// payload. The payload is not empty and shorter than 4 GB.
std::string recordOf(std::string_view payload);

/// Goes through the records of a file.
class RecordReader {
 public:
  /// Reads nothing where the bytes do not begin with the magic ones.
  explicit RecordReader(std::string_view bytes);
  /// Returns the next payload; absent at the end, and at the first record that is torn or damaged.
  std::optional<std::string_view> next();
  /// Does the same but passes over records that are damaged, where what follows makes sense without
  /// them.
  std::optional<std::string_view> nextWhole();

 private:
  /// Takes a record; `whole` becomes false where it is not as it was written.
  std::optional<std::string_view> take(bool& whole);
  std::string_view m_rest;
};

void appendNumber(std::string& bytes, std::uint32_t number);
/// Takes a number, the lowest byte first, from the beginning of the bytes; absent where they end.
std::optional<std::uint32_t> takeNumber(std::string_view& bytes);
/// Takes that many bytes from the beginning; absent where there are fewer.
std::optional<std::string_view> takeBytes(std::string_view& bytes, std::size_t count);

}  // namespace sline::model
