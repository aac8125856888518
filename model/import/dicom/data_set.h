// SPDX-License-Identifier: Apache-2.0
// Gives DICOM data elements (PS3.5 §7) as C++ values. DCMTK has read them, in whatever way they
// were written; a value that a file calls a number and that is none counts as absent here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/import/dicom/tag.h"

class DcmItem;

namespace sline::model {

/// Represents one level of elements: a file's or a sequence item's. It refers to the file
/// (DicomFile), which must outlive it.
class DataSet {
 public:
  DataSet() = default;
  /// `charset` is that of the level above, for an item that names none of its own.
  explicit DataSet(DcmItem& item, const std::string& charset = {});

  bool has(Tag tag) const;
  /// Returns the items of a sequence, or none where it is absent.
  std::vector<DataSet> items(Tag tag) const;
  /// Returns the first item of a sequence, or nothing where there is none.
  std::optional<DataSet> item(Tag tag) const;

  /// Returns the value's bytes without the blanks and zeros that pad it; empty where it is absent.
  std::string text(Tag tag) const;
  /// Returns the value as UTF-8, by the character set that holds at this level (character_sets.h).
  std::string utf8(Tag tag) const;
  /// Returns DS and IS values, which are numbers as text with backslashes between. Returns nothing
  /// where the element is absent or empty, or where one of them is no finite number.
  std::optional<std::vector<double>> decimals(Tag tag) const;
  /// Does the same, but returns nothing unless there are exactly `count` numbers.
  std::optional<std::vector<double>> decimals(Tag tag, std::size_t count) const;
  /// Returns the first of the numbers.
  std::optional<double> decimal(Tag tag) const;
  /// Returns an IS that has one value.
  std::optional<std::int64_t> integer(Tag tag) const;
  /// Returns the first value of US or UL, or the bits of the first SS value.
  std::optional<std::uint32_t> number(Tag tag) const;
  /// Returns all values of US.
  std::vector<std::uint16_t> shorts(Tag tag) const;

 private:
  DcmItem* m_item = nullptr;
  std::string m_charset;
};

}  // namespace sline::model
