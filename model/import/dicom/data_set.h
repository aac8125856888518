// SPDX-License-Identifier: Apache-2.0
// DICOM data elements (PS3.5 §7) as values of C++. DCMTK has read them, in whatever way they were
// written; what a file calls a number and is none is absent here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/import/dicom/tag.h"

class DcmItem;

namespace sline::model {

/// One level of elements: a file's or a sequence item's. It refers to the file (DicomFile), which
/// must outlive it.
class DataSet {
 public:
  DataSet() = default;
  /// `charset`: of the level above, for an item that names none of its own.
  explicit DataSet(DcmItem& item, const std::string& charset = {});

  bool has(Tag tag) const;
  /// The items of a sequence, none where it is absent.
  std::vector<DataSet> items(Tag tag) const;
  /// The first item of a sequence; nothing where there is none.
  std::optional<DataSet> item(Tag tag) const;

  /// The value's bytes without the blanks and zeros that pad it; empty where absent.
  std::string text(Tag tag) const;
  /// The same as UTF-8, by the character set that holds at this level (character_sets.h).
  std::string utf8(Tag tag) const;
  /// DS and IS: numbers as text with backslashes between. Nothing where absent, empty, or where one
  /// of them is no finite number.
  std::optional<std::vector<double>> decimals(Tag tag) const;
  /// The same where there are just so many.
  std::optional<std::vector<double>> decimals(Tag tag, std::size_t count) const;
  /// The first of them.
  std::optional<double> decimal(Tag tag) const;
  /// IS with one value.
  std::optional<std::int64_t> integer(Tag tag) const;
  /// The first value of US or UL; of SS as the same bits.
  std::optional<std::uint32_t> number(Tag tag) const;
  /// All values of US.
  std::vector<std::uint16_t> shorts(Tag tag) const;

 private:
  DcmItem* m_item = nullptr;
  std::string m_charset;
};

}  // namespace sline::model
