// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/dicom_identity.h"

#include <cstdint>
#include <optional>

#include "model/import/readers/dicom_kind.h"
#include "model/import/source/packed_bytes.h"

namespace sline::model {

namespace {

constexpr std::size_t metaBegin = 132;
constexpr std::uint32_t openLength = 0xffffffff;
constexpr std::uint32_t itemBegin = 0xfffee000;
constexpr std::uint32_t itemEnd = 0xfffee00d;
constexpr std::uint32_t sequenceEnd = 0xfffee0dd;
constexpr std::uint32_t syntaxUid = 0x00020010;
constexpr std::uint32_t nameTag = 0x00100010;
constexpr std::uint32_t idTag = 0x00100020;
constexpr std::uint32_t studyTag = 0x0020000d;
constexpr std::uint32_t frameTag = 0x00200052;
constexpr std::uint32_t referencedFrames = 0x30060010;
/// Elements from here on say nothing of whose the object is, unless it is a structure set.
constexpr std::uint32_t behindIdentity = 0x00210000;
constexpr std::uint32_t behindFrames = 0x30060011;
constexpr int deepest = 12;

std::string_view withoutPadding(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view(" \0", 2));
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

class IdentityWalk {
 public:
  IdentityWalk(std::string_view text, bool bigEndian, DicomIdentity& found)
      : m_text(text), m_bigEndian(bigEndian), m_found(found) {}

  /// Reads the elements up to `end`, or up to an item's end; returns false where they cannot be
  /// followed any further.
  bool elements(std::size_t end, int depth) {
    while (m_at < end) {
      const std::optional<Head> head = next();
      if (!head)
        return false;
      if (head->tag == itemEnd)
        return true;
      if (depth == 0 && isBehind(head->tag)) {
        m_found.complete = true;
        return false;
      }
      if (head->sequence ? !items(*head, depth) : !value(*head, depth))
        return false;
    }
    m_found.complete = m_found.complete || (depth == 0 && m_at == m_text.size());
    return true;
  }

 private:
  struct Head {
    std::uint32_t tag = 0;
    std::uint32_t length = 0;
    bool sequence = false;
  };

  bool isBehind(std::uint32_t tag) const {
    return tag >= (m_found.frameOfReference.empty() ? behindFrames : behindIdentity);
  }

  std::uint32_t number(std::size_t at, std::size_t bytes) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t place = m_bigEndian ? bytes - 1 - i : i;
      value |= std::uint32_t(static_cast<unsigned char>(m_text[at + i])) << (8 * place);
    }
    return value;
  }

  /// Reads an element's head and moves to its value.
  std::optional<Head> next() {
    if (m_at + 8 > m_text.size())
      return std::nullopt;
    Head head{.tag = number(m_at, 2) << 16 | number(m_at + 2, 2)};
    const std::string_view vr = m_text.substr(m_at + 4, 2);
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const bool ofItems = head.tag >> 16 == itemBegin >> 16;
    if (ofItems || !capital(vr[0]) || !capital(vr[1])) {
      head.length = number(m_at + 4, 4);
      m_at += 8;
    } else if (vr == "OB" || vr == "OW" || vr == "OF" || vr == "OD" || vr == "OL" || vr == "OV" ||
               vr == "SQ" || vr == "UN" || vr == "UT" || vr == "UC" || vr == "UR" || vr == "SV" ||
               vr == "UV") {
      if (m_at + 12 > m_text.size())
        return std::nullopt;
      head.length = number(m_at + 8, 4);
      m_at += 12;
    } else {
      head.length = number(m_at + 6, 2);
      m_at += 8;
    }
    head.sequence =
        !ofItems && (vr == "SQ" || head.length == openLength || head.tag == referencedFrames);
    return head;
  }

  bool value(const Head& head, int depth) {
    if (head.length > m_text.size() - m_at)
      return false;
    const std::string_view text = withoutPadding(m_text.substr(m_at, head.length));
    m_at += head.length;
    if (depth == 0 && head.tag == nameTag)
      m_found.patientName = text;
    else if (depth == 0 && head.tag == idTag)
      m_found.patientId = text;
    else if (depth == 0 && head.tag == studyTag)
      m_found.study = text;
    else if (head.tag == frameTag && (depth == 0 || m_inFrames) && m_found.frameOfReference.empty())
      m_found.frameOfReference = text;
    return true;
  }

  bool items(const Head& head, int depth) {
    if (depth == deepest)
      return false;
    const bool open = head.length == openLength;
    if (!open && head.length > m_text.size() - m_at && head.tag != referencedFrames)
      return false;
    const std::size_t end = open ? m_text.size() : std::min(m_text.size(), m_at + head.length);
    if (!open && head.tag != referencedFrames) {
      m_at = end;
      return true;
    }
    const bool before = m_inFrames;
    m_inFrames = depth == 0 && head.tag == referencedFrames;
    while (m_at < end) {
      const std::optional<Head> item = next();
      if (!item || (item->tag != itemBegin && item->tag != sequenceEnd))
        return false;
      if (item->tag == sequenceEnd)
        break;
      const std::size_t itemStops = item->length == openLength
                                        ? m_text.size()
                                        : std::min<std::size_t>(m_text.size(), m_at + item->length);
      if (!elements(itemStops, depth + 1))
        return false;
    }
    m_inFrames = before;
    return true;
  }

  std::string_view m_text;
  bool m_bigEndian;
  DicomIdentity& m_found;
  std::size_t m_at = 0;
  bool m_inFrames = false;
};

/// Returns the transfer syntax and where the data set begins; the meta header is always explicit
/// and little endian.
std::string_view syntaxIn(std::string_view text, std::size_t& dataBegin) {
  const auto number = [text](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      value |= std::uint32_t(static_cast<unsigned char>(text[at + i])) << (8 * i);
    return value;
  };
  std::string_view syntax;
  while (dataBegin + 12 <= text.size() && number(dataBegin, 2) == 2) {
    const std::uint32_t tag = number(dataBegin, 2) << 16 | number(dataBegin + 2, 2);
    const std::string_view vr = text.substr(dataBegin + 4, 2);
    const bool wide = vr == "OB" || vr == "UN";
    const std::size_t length = wide ? number(dataBegin + 8, 4) : number(dataBegin + 6, 2);
    const std::size_t value = dataBegin + (wide ? 12 : 8);
    if (length > text.size() - value)
      break;
    if (tag == syntaxUid)
      syntax = withoutPadding(text.substr(value, length));
    dataBegin = value + length;
  }
  return syntax;
}

/// Returns the first bytes of raw deflated data.
std::string inflated(std::string_view packed) {
  constexpr std::size_t enough = std::size_t(8) << 20;
  // What two bytes make of it is zlib's own format, whose checksum nobody comes to.
  const std::string stream = "\x78\x01" + std::string(packed);
  PackedBytes bytes(stream, Packing::deflated);
  std::string text(enough, '\0');
  text.resize(bytes.read(text.data(), enough));
  return text;
}

}  // namespace

DicomIdentity dicomIdentity(std::string_view text) {
  DicomIdentity found;
  if (!beginsLikeDicom(text))
    return {.complete = true};
  std::size_t begin = text.size() >= metaBegin && text.substr(metaBegin - 4, 4) == "DICM"
                          ? metaBegin
                          : std::size_t(0);
  const std::string_view syntax = syntaxIn(text, begin);
  std::string data;
  std::string_view elements = text.substr(begin);
  if (syntax == "1.2.840.10008.1.2.1.99") {
    data = inflated(elements);
    elements = data;
  }
  IdentityWalk(elements, syntax == "1.2.840.10008.1.2.2", found).elements(elements.size(), 0);
  return found;
}

}  // namespace sline::model
