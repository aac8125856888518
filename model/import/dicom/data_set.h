// SPDX-License-Identifier: Apache-2.0
// DICOM data elements (PS3.5 §7), little endian, explicit or implicit VR. Elements point into the
// file; sequences are parsed when they are asked for. Every length is checked against what is left
// before it is believed, and nesting is bounded. GDCM was tried and is not used: files of 4 kB with
// one changed length stop its reader at an assertion or make it take 750 MB.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/readers/source.h"

namespace sline::model {

struct Tag {
  std::uint16_t group = 0;
  std::uint16_t element = 0;
  auto operator<=>(const Tag&) const = default;
};
/// "(3006,0050)"
std::string shown(Tag tag);

/// A file and the bytes its elements stand in: its own or, for the deflated transfer syntax, those
/// unpacked from it.
struct DicomBytes {
  const Source* source = nullptr;  ///< null: errors name no place
  std::string_view text;
  bool unpacked = false;

  Error at(const char* place, std::string reason, std::string remedy = {}) const;
};

/// Whether the character may stand in a value representation, such as "UI".
constexpr bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}

struct DataElement {
  Tag tag;
  std::string_view value;   ///< of a sequence: its items, without the delimiter behind them
  bool undefined = false;   ///< the file left the length open
  bool explicitVr = false;  ///< how the items in it are written
};

/// One level of elements: a file's or a sequence item's.
class DataSet {
 public:
  /// The elements in `text`, which lies in `bytes`.
  static Result<DataSet> parse(const DicomBytes& bytes, std::string_view text, bool explicitVr);

  const DataElement* find(Tag tag) const;
  const std::vector<DataElement>& elements() const { return m_elements; }
  const DicomBytes& bytes() const { return *m_bytes; }
  /// The items of a sequence, none where it is absent.
  Result<std::vector<DataSet>> items(Tag tag) const;
  /// The first item of a sequence; nothing where there is none.
  Result<std::optional<DataSet>> item(Tag tag) const;

  /// The value without the blanks and zeros that pad it; empty where absent.
  std::string_view text(Tag tag) const;
  /// DS and IS: numbers as text with backslashes between. Nothing where absent, empty, or where one
  /// of them is no finite number.
  std::optional<std::vector<double>> decimals(Tag tag) const;
  /// IS with one value.
  std::optional<std::int64_t> integer(Tag tag) const;
  /// The first value of US or UL.
  std::optional<std::uint32_t> number(Tag tag) const;
  /// All values of US.
  std::vector<std::uint16_t> shorts(Tag tag) const;
  std::vector<std::uint32_t> longs(Tag tag) const;

 private:
  const DicomBytes* m_bytes = nullptr;
  std::vector<DataElement> m_elements;
};

/// The text of the first such element at the top level of what may be cut off somewhere behind it;
/// empty without.
std::string_view firstTextIn(std::string_view text, Tag wanted, bool explicitVr);

/// The fragments of encapsulated pixel data (PS3.5 §A.4), the offset table first.
Result<std::vector<std::string_view>> fragmentsOf(const DicomBytes& bytes,
                                                  const DataElement& element);

}  // namespace sline::model
