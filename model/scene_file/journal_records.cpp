// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/journal_records.h"

#include "model/scene_file/fingerprint.h"

namespace sline::model {

std::string recordOf(std::string_view payload) {
  std::string record;
  record.reserve(payload.size() + 8);
  appendNumber(record, std::uint32_t(payload.size()));
  appendNumber(record, fingerprintOf(payload).crc);
  record += payload;
  return record;
}

RecordReader::RecordReader(std::string_view bytes) {
  if (bytes.starts_with(journalMagic))
    m_rest = bytes.substr(journalMagic.size());
}

std::optional<std::string_view> RecordReader::take(bool& whole) {
  const auto length = takeNumber(m_rest);
  const auto crc = takeNumber(m_rest);
  // A power cut may leave zeros at the end; the checksum of nothing is zero too.
  const auto payload = length && crc && *length > 0 ? takeBytes(m_rest, *length) : std::nullopt;
  whole = payload && fingerprintOf(*payload).crc == *crc;
  if (!payload)
    m_rest = {};
  return payload;
}

std::optional<std::string_view> RecordReader::next() {
  bool whole = false;
  const auto payload = take(whole);
  if (whole)
    return payload;
  m_rest = {};
  return std::nullopt;
}

std::optional<std::string_view> RecordReader::nextWhole() {
  bool whole = false;
  auto payload = take(whole);
  while (payload && !whole)
    payload = take(whole);
  return payload;
}

void appendNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += char(number >> shift & 0xff);
}

std::optional<std::uint32_t> takeNumber(std::string_view& bytes) {
  const auto four = takeBytes(bytes, 4);
  if (!four)
    return std::nullopt;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number |= std::uint32_t(std::uint8_t((*four)[i])) << 8 * i;
  return number;
}

std::optional<std::string_view> takeBytes(std::string_view& bytes, std::size_t count) {
  if (bytes.size() < count)
    return std::nullopt;
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

}  // namespace sline::model
