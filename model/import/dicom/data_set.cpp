// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/data_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "model/import/readers/values.h"

namespace sline::model {

namespace {

constexpr int deepest = 16;
constexpr std::uint32_t openLength = 0xffffffffu;
constexpr std::uint16_t delimiters = 0xfffe;
constexpr Tag itemTag{delimiters, 0xe000};
constexpr Tag itemEnd{delimiters, 0xe00d};
constexpr Tag sequenceEnd{delimiters, 0xe0dd};
constexpr bool swapped = std::endian::native != std::endian::little;
constexpr const char* sendAgain = "Copy or export the file again; it is incomplete or damaged";

/// VRs whose length takes four bytes (PS3.5 table 7.1-1).
bool isLong(std::string_view vr) {
  constexpr std::array<std::string_view, 13> names{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                   "SV", "UC", "UN", "UR", "UT", "UV"};
  return std::find(names.begin(), names.end(), vr) != names.end();
}

/// Walks along the elements of one level.
class Cursor {
 public:
  Cursor(const DicomBytes& bytes, std::string_view text, bool explicitVr, int depth)
      : m_bytes(bytes),
        m_at(text.data()),
        m_end(text.data() + text.size()),
        m_explicit(explicitVr),
        m_depth(depth) {}

  bool atEnd() const { return m_at == m_end; }
  const char* at() const { return m_at; }
  /// True, and behind it, where the next eight bytes are this delimiter.
  bool skipDelimiter(Tag tag) {
    if (left() < 8 || tagHere() != tag)
      return false;
    m_at += 8;
    return true;
  }

  Result<DataElement> next() {
    const char* start = m_at;
    if (left() < 8)
      return m_bytes.at(start, "the file ends within an element's head", sendAgain);
    DataElement element{.tag = tagHere(), .explicitVr = m_explicit};
    if (element.tag.group == delimiters)
      return m_bytes.at(start, "an item or delimiter stands where an element should", sendAgain);
    std::uint32_t length = 0;
    if (!m_explicit) {
      length = loadAs<std::uint32_t>(m_at + 4, swapped);
      m_at += 8;
    } else if (std::optional<Error> error = explicitHead(element, length)) {
      return *error;
    }
    if (length == openLength)
      return open(element);
    if (length > left())
      return m_bytes.at(start,
                        "the element " + shown(element.tag) + " promises " +
                            std::to_string(length) + " bytes, " + std::to_string(left()) +
                            " are left",
                        sendAgain);
    element.value = {m_at, length};
    m_at += length;
    return element;
  }

  /// One item of a sequence: its bytes, without head and delimiter.
  Result<std::string_view> item() {
    const char* start = m_at;
    if (left() < 8 || tagHere() != itemTag)
      return m_bytes.at(start, "a sequence goes on with something that is no item", sendAgain);
    const auto length = loadAs<std::uint32_t>(m_at + 4, swapped);
    m_at += 8;
    if (length != openLength) {
      if (length > left())
        return m_bytes.at(start,
                          "an item promises " + std::to_string(length) + " bytes, " +
                              std::to_string(left()) + " are left",
                          sendAgain);
      m_at += length;
      return std::string_view(m_at - length, length);
    }
    const char* begin = m_at;
    while (true) {
      const char* end = m_at;
      if (skipDelimiter(itemEnd))
        return std::string_view(begin, std::size_t(end - begin));
      if (Result<DataElement> element = next(); !element)
        return element.error();
    }
  }

 private:
  std::size_t left() const { return std::size_t(m_end - m_at); }
  Tag tagHere() const {
    return {loadAs<std::uint16_t>(m_at, swapped), loadAs<std::uint16_t>(m_at + 2, swapped)};
  }

  std::optional<Error> explicitHead(DataElement& element, std::uint32_t& length) {
    const std::string_view vr(m_at + 4, 2);
    if (!isUpper(vr[0]) || !isUpper(vr[1]))
      return m_bytes.at(m_at, "the element " + shown(element.tag) + " has no value representation",
                        sendAgain);
    if (!isLong(vr)) {
      length = loadAs<std::uint16_t>(m_at + 6, swapped);
      m_at += 8;
      return std::nullopt;
    }
    if (left() < 12)
      return m_bytes.at(m_at, "the file ends within an element's head", sendAgain);
    length = loadAs<std::uint32_t>(m_at + 8, swapped);
    m_at += 12;
    // A sequence of a kind its writer did not know keeps the implicit form (PS3.5 §6.2.2).
    if (vr == "UN")
      element.explicitVr = false;
    return std::nullopt;
  }

  Result<DataElement> open(DataElement element) {
    element.undefined = true;
    if (m_depth >= deepest)
      return m_bytes.at(m_at, "sequences are nested more than 16 deep", sendAgain);
    Cursor inner(m_bytes, {m_at, left()}, element.explicitVr, m_depth + 1);
    while (true) {
      const char* end = inner.at();
      if (inner.skipDelimiter(sequenceEnd)) {
        element.value = {m_at, std::size_t(end - m_at)};
        m_at = inner.at();
        return element;
      }
      if (Result<std::string_view> item = inner.item(); !item)
        return item.error();
    }
  }

  const DicomBytes& m_bytes;
  const char* m_at;
  const char* m_end;
  bool m_explicit;
  int m_depth;
};

std::string_view trimmed(std::string_view text) {
  const auto pads = [](char c) { return c == ' ' || c == '\0'; };
  while (!text.empty() && pads(text.back()))
    text.remove_suffix(1);
  while (!text.empty() && pads(text.front()))
    text.remove_prefix(1);
  return text;
}

std::optional<double> decimal(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

template <class T>
std::vector<T> loadAll(std::string_view bytes) {
  std::vector<T> values;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T))
    values.push_back(loadAs<T>(bytes.data() + i, swapped));
  return values;
}

}  // namespace

std::string shown(Tag tag) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto hex = [&](unsigned number) {
    std::string text;
    for (int shift = 12; shift >= 0; shift -= 4)
      text += digits[(number >> unsigned(shift)) & 15u];
    return text;
  };
  return "(" + hex(tag.group) + "," + hex(tag.element) + ")";
}

Error DicomBytes::at(const char* place, std::string reason, std::string remedy) const {
  if (remedy.empty())
    remedy = sendAgain;
  if (!source)
    return {.reason = std::move(reason), .remedy = std::move(remedy)};
  if (!unpacked)
    return source->atByte(place, std::move(reason), std::move(remedy));
  const char* begin = text.data();
  return source->at("byte " +
                        std::to_string(std::clamp(place, begin, begin + text.size()) - begin) +
                        " of the unpacked data",
                    std::move(reason), std::move(remedy));
}

Result<DataSet> DataSet::parse(const DicomBytes& bytes, std::string_view text, bool explicitVr) {
  DataSet set;
  set.m_bytes = &bytes;
  Cursor cursor(bytes, text, explicitVr, 0);
  while (!cursor.atEnd()) {
    Result<DataElement> element = cursor.next();
    if (!element)
      return element.error();
    set.m_elements.push_back(*element);
  }
  return set;
}

const DataElement* DataSet::find(Tag tag) const {
  const auto found = std::find_if(m_elements.begin(), m_elements.end(),
                                  [&](const DataElement& element) { return element.tag == tag; });
  return found == m_elements.end() ? nullptr : &*found;
}

Result<std::vector<DataSet>> DataSet::items(Tag tag) const {
  std::vector<DataSet> sets;
  const DataElement* element = find(tag);
  if (!element)
    return sets;
  Cursor cursor(*m_bytes, element->value, element->explicitVr, 0);
  while (!cursor.atEnd() && !cursor.skipDelimiter(sequenceEnd)) {
    Result<std::string_view> item = cursor.item();
    if (!item)
      return item.error();
    Result<DataSet> set = parse(*m_bytes, *item, element->explicitVr);
    if (!set)
      return set.error();
    sets.push_back(std::move(*set));
  }
  return sets;
}

Result<std::optional<DataSet>> DataSet::item(Tag tag) const {
  const DataElement* element = find(tag);
  if (!element || element->value.empty())
    return std::optional<DataSet>();
  Cursor cursor(*m_bytes, element->value, element->explicitVr, 0);
  Result<std::string_view> item = cursor.item();
  if (!item)
    return item.error();
  Result<DataSet> set = parse(*m_bytes, *item, element->explicitVr);
  if (!set)
    return set.error();
  return std::optional(std::move(*set));
}

std::string_view DataSet::text(Tag tag) const {
  const DataElement* element = find(tag);
  return element ? trimmed(element->value) : std::string_view();
}

std::optional<std::vector<double>> DataSet::decimals(Tag tag) const {
  std::string_view rest = text(tag);
  if (rest.empty())
    return std::nullopt;
  std::vector<double> values;
  while (true) {
    const std::size_t end = rest.find('\\');
    const std::optional<double> value = decimal(rest.substr(0, end));
    if (!value)
      return std::nullopt;
    values.push_back(*value);
    if (end == std::string_view::npos)
      return values;
    rest.remove_prefix(end + 1);
  }
}

std::optional<std::int64_t> DataSet::integer(Tag tag) const {
  const std::optional<double> value = decimal(text(tag));
  if (!value || std::abs(*value) > 4e9 || *value != std::floor(*value))
    return std::nullopt;
  return std::int64_t(*value);
}

std::optional<std::uint32_t> DataSet::number(Tag tag) const {
  const DataElement* element = find(tag);
  if (!element || element->value.size() < 2)
    return std::nullopt;
  if (element->value.size() == 2)
    return loadAs<std::uint16_t>(element->value.data(), swapped);
  if (element->value.size() >= 4)
    return loadAs<std::uint32_t>(element->value.data(), swapped);
  return std::nullopt;
}

std::vector<std::uint16_t> DataSet::shorts(Tag tag) const {
  const DataElement* element = find(tag);
  return element ? loadAll<std::uint16_t>(element->value) : std::vector<std::uint16_t>();
}

std::vector<std::uint32_t> DataSet::longs(Tag tag) const {
  const DataElement* element = find(tag);
  return element ? loadAll<std::uint32_t>(element->value) : std::vector<std::uint32_t>();
}

std::string_view firstTextIn(std::string_view text, Tag wanted, bool explicitVr) {
  const DicomBytes bytes{nullptr, text};
  Cursor cursor(bytes, text, explicitVr, 0);
  while (!cursor.atEnd()) {
    const Result<DataElement> element = cursor.next();
    if (!element)
      return {};
    if (element->tag == wanted)
      return trimmed(element->value);
  }
  return {};
}

Result<std::vector<std::string_view>> fragmentsOf(const DicomBytes& bytes,
                                                  const DataElement& element) {
  std::vector<std::string_view> fragments;
  Cursor cursor(bytes, element.value, element.explicitVr, 0);
  while (!cursor.atEnd()) {
    Result<std::string_view> item = cursor.item();
    if (!item)
      return item.error();
    fragments.push_back(*item);
  }
  return fragments;
}

}  // namespace sline::model
