// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/deflate.h"

#include <zlib.h>

#include <algorithm>

#include "model/base/parallel.h"
#include "render/export/encoding/byte_order.h"

namespace sline::render {

namespace {

constexpr int level = 5;
constexpr std::size_t windowSize = 32768;

const Bytef* asBytes(std::span<const std::byte> bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

/// Deflates without header and checksum and ends at a whole byte, so that more can follow.
std::string rawPart(std::span<const std::byte> bytes, std::span<const std::byte> before) {
  z_stream stream{};
  deflateInit2(&stream, level, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  if (!before.empty())
    deflateSetDictionary(&stream, asBytes(before), uInt(before.size()));
  std::string out(deflateBound(&stream, uLong(bytes.size())) + 16, '\0');
  stream.next_in = const_cast<Bytef*>(asBytes(bytes));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_SYNC_FLUSH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

std::uint32_t checksumOf(std::span<const std::byte> bytes) {
  return std::uint32_t(adler32(adler32(0, nullptr, 0), asBytes(bytes), uInt(bytes.size())));
}

}  // namespace

std::string zlibStream(std::span<const std::byte> bytes) {
  uLongf length = compressBound(uLong(bytes.size()));
  std::string out(length, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &length, asBytes(bytes), uLong(bytes.size()),
            level);
  out.resize(length);
  return out;
}

DeflateStream::DeflateStream() : m_checksum(std::uint32_t(adler32(0, nullptr, 0))) {}

std::vector<std::string> DeflateStream::add(std::span<const std::span<const std::byte>> parts) {
  std::vector<std::string> out(parts.size());
  std::vector<std::uint32_t> checksums(parts.size());
  parallelFor(parts.size(), 1, [&](std::size_t i) {
    std::span<const std::byte> before(m_window);
    if (i > 0) {
      const std::byte* start = parts.front().data();
      const auto length = std::min(windowSize, std::size_t(parts[i].data() - start));
      before = {parts[i].data() - length, length};
    }
    out[i] = rawPart(parts[i], before);
    checksums[i] = checksumOf(parts[i]);
  });
  for (std::size_t i = 0; i < parts.size(); ++i)
    m_checksum = std::uint32_t(adler32_combine(m_checksum, checksums[i], z_off_t(parts[i].size())));
  if (!parts.empty()) {
    const std::span<const std::byte> last = parts.back();
    const std::size_t all = std::size_t(last.data() + last.size() - parts.front().data());
    const std::size_t length = std::min(windowSize, all);
    m_window.assign(last.data() + last.size() - length, last.data() + last.size());
    if (!m_begun)
      out.front().insert(0, "\x78\x5E");  // deflate, 32 KiB, a fast level
    m_begun = true;
  }
  return out;
}

std::string DeflateStream::finish() const {
  const std::string head = m_begun ? std::string() : std::string("\x78\x5E");
  // An empty last block of the fixed kind.
  return head + std::string("\x03\x00", 2) + bigEndian(m_checksum, 4);
}

}  // namespace sline::render
