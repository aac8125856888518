// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/data_set.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <dcmtk/dcmdata/dcsequen.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "model/import/dicom/character_sets.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

constexpr Tag specificCharacterSet{0x0008, 0x0005};

DcmElement* elementIn(DcmItem* item, Tag tag) {
  DcmElement* element = nullptr;
  if (item && item->findAndGetElement({tag.group, tag.element}, element).good())
    return element;
  return nullptr;
}

DcmSequenceOfItems* sequenceIn(DcmItem* item, Tag tag) {
  DcmElement* element = elementIn(item, tag);
  return element && element->ident() == EVR_SQ ? static_cast<DcmSequenceOfItems*>(element)
                                               : nullptr;
}

/// Returns text as it stands in the file. A value of a kind that the writer called unknown comes as
/// bytes.
std::string_view bytesOf(DcmElement* element) {
  if (!element)
    return {};
  char* text = nullptr;
  Uint32 size = 0;
  if (element->getString(text, size).good())
    return text ? std::string_view(text, size) : std::string_view();
  Uint8* bytes = nullptr;
  if (element->getUint8Array(bytes).good() && bytes)
    return {reinterpret_cast<const char*>(bytes), element->getLength()};
  return {};
}

std::string_view trimmed(std::string_view text) {
  const auto pads = [](char c) { return c == ' ' || c == '\0'; };
  while (!text.empty() && pads(text.back()))
    text.remove_suffix(1);
  while (!text.empty() && pads(text.front()))
    text.remove_prefix(1);
  return text;
}

std::optional<double> decimalIn(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace

DataSet::DataSet(DcmItem& item, const std::string& charset) : m_item(&item) {
  m_charset = has(specificCharacterSet) ? text(specificCharacterSet) : charset;
}

bool DataSet::has(Tag tag) const {
  return elementIn(m_item, tag) != nullptr;
}

std::vector<DataSet> DataSet::items(Tag tag) const {
  std::vector<DataSet> sets;
  DcmSequenceOfItems* sequence = sequenceIn(m_item, tag);
  DcmObject* object = sequence ? sequence->nextInContainer(nullptr) : nullptr;
  for (; object; object = sequence->nextInContainer(object))
    if (auto* item = dynamic_cast<DcmItem*>(object))
      sets.emplace_back(*item, m_charset);
  return sets;
}

std::optional<DataSet> DataSet::item(Tag tag) const {
  DcmSequenceOfItems* sequence = sequenceIn(m_item, tag);
  DcmItem* item = sequence && sequence->card() > 0 ? sequence->getItem(0) : nullptr;
  return item ? std::optional(DataSet(*item, m_charset)) : std::nullopt;
}

std::string DataSet::text(Tag tag) const {
  return std::string(trimmed(bytesOf(elementIn(m_item, tag))));
}

std::string DataSet::utf8(Tag tag) const {
  return inUtf8(text(tag), m_charset);
}

std::optional<std::vector<double>> DataSet::decimals(Tag tag) const {
  std::string_view rest = trimmed(bytesOf(elementIn(m_item, tag)));
  if (rest.empty())
    return std::nullopt;
  std::vector<double> values;
  while (true) {
    const std::size_t end = rest.find('\\');
    const std::optional<double> value = decimalIn(rest.substr(0, end));
    if (!value)
      return std::nullopt;
    values.push_back(*value);
    if (end == std::string_view::npos)
      return values;
    rest.remove_prefix(end + 1);
  }
}

std::optional<std::vector<double>> DataSet::decimals(Tag tag, std::size_t count) const {
  std::optional<std::vector<double>> values = decimals(tag);
  if (values && values->size() != count)
    values.reset();
  return values;
}

std::optional<double> DataSet::decimal(Tag tag) const {
  const std::optional<std::vector<double>> values = decimals(tag);
  return values ? std::optional(values->front()) : std::nullopt;
}

std::optional<std::int64_t> DataSet::integer(Tag tag) const {
  const std::optional<double> value = decimalIn(bytesOf(elementIn(m_item, tag)));
  if (!value || std::abs(*value) > 4e9 || *value != std::floor(*value))
    return std::nullopt;
  return std::int64_t(*value);
}

std::optional<std::uint32_t> DataSet::number(Tag tag) const {
  DcmElement* element = elementIn(m_item, tag);
  if (!element || element->getLength() == 0)
    return std::nullopt;
  Uint16 shortValue = 0;
  if (element->getUint16(shortValue).good())
    return shortValue;
  Sint16 signedValue = 0;
  if (element->getSint16(signedValue).good())
    return std::uint16_t(signedValue);
  Uint32 longValue = 0;
  if (element->getUint32(longValue).good())
    return longValue;
  const std::string_view bytes = bytesOf(element);
  const bool swapped = std::endian::native != std::endian::little;
  if (bytes.size() == 2)
    return loadAs<std::uint16_t>(bytes.data(), swapped);
  if (bytes.size() == 4)
    return loadAs<std::uint32_t>(bytes.data(), swapped);
  return std::nullopt;
}

std::vector<std::uint16_t> DataSet::shorts(Tag tag) const {
  DcmElement* element = elementIn(m_item, tag);
  Uint16* values = nullptr;
  if (element && element->getUint16Array(values).good() && values)
    return {values, values + element->getLength() / 2};
  const std::string_view bytes = bytesOf(element);
  std::vector<std::uint16_t> all;
  for (std::size_t i = 0; i + 2 <= bytes.size(); i += 2)
    all.push_back(loadAs<std::uint16_t>(&bytes[i], std::endian::native != std::endian::little));
  return all;
}

}  // namespace sline::model
