// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/packed_bytes.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "model/import/source/text_cursor.h"

namespace sline::model {

struct PackedBytes::Unpacker {
  virtual ~Unpacker() = default;
  virtual std::size_t read(char* to, std::size_t count) = 0;
  bool broken = false;
  bool cutOff = false;
};

namespace {

constexpr std::size_t mostAtOnce = std::size_t(1) << 30;

class Plain : public PackedBytes::Unpacker {
 public:
  explicit Plain(std::string_view bytes) : m_bytes(bytes) {}
  std::size_t read(char* to, std::size_t count) override {
    count = std::min(count, m_bytes.size());
    std::memcpy(to, m_bytes.data(), count);
    m_bytes.remove_prefix(count);
    return count;
  }

 private:
  std::string_view m_bytes;
};

class Hex : public PackedBytes::Unpacker {
 public:
  explicit Hex(std::string_view text) : m_text(text) {}
  std::size_t read(char* to, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) {
      const int high = digit();
      const int low = high < 0 ? -1 : digit();
      if (low < 0) {
        broken = broken || high >= 0;
        return i;
      }
      to[i] = char(16 * high + low);
    }
    return count;
  }

 private:
  int digit() {
    while (m_at < m_text.size() && TextCursor::isSpace(m_text[m_at]))
      ++m_at;
    if (m_at == m_text.size())
      return -1;
    const char c = m_text[m_at];
    const char lower = char(c | 0x20);
    const int value = c >= '0' && c <= '9'           ? c - '0'
                      : lower >= 'a' && lower <= 'f' ? lower - 'a' + 10
                                                     : -1;
    broken = broken || value < 0;
    m_at += value >= 0;
    return value;
  }

  std::string_view m_text;
  std::size_t m_at = 0;
};

class Deflated : public PackedBytes::Unpacker {
 public:
  explicit Deflated(std::string_view packed) : m_packed(packed) {
    // 15 is the largest window; + 32 tells gzip and zlib apart by their beginning.
    m_open = inflateInit2(&m_stream, 15 + 32) == Z_OK;
    broken = !m_open;
  }
  ~Deflated() override {
    if (m_open)
      inflateEnd(&m_stream);
  }
  Deflated(const Deflated&) = delete;
  Deflated& operator=(const Deflated&) = delete;

  std::size_t read(char* to, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && !broken && !m_ended) {
      feed();
      m_stream.next_out = reinterpret_cast<Bytef*>(to + done);
      const std::size_t room = std::min(count - done, mostAtOnce);
      m_stream.avail_out = uInt(room);
      const uInt given = m_stream.avail_in;
      const int state = inflate(&m_stream, Z_NO_FLUSH);
      const std::size_t got = room - m_stream.avail_out;
      done += got;
      if (state == Z_STREAM_END)
        nextMember();
      else if (state != Z_OK && state != Z_BUF_ERROR)
        broken = true;
      else if (got == 0 && given == m_stream.avail_in)
        m_ended = cutOff = true;
    }
    return done;
  }

 private:
  void feed() {
    if (m_stream.avail_in > 0 || m_packed.empty())
      return;
    const std::size_t piece = std::min(m_packed.size(), mostAtOnce);
    // zlib's interface is older than the keyword const.
    m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_packed.data()));
    m_stream.avail_in = uInt(piece);
    m_packed.remove_prefix(piece);
  }

  /// Moves to the next member: gzip files may be concatenated; bytes that follow and are no gzip
  /// member are ignored.
  void nextMember() {
    feed();
    const bool more =
        m_stream.avail_in >= 2 && m_stream.next_in[0] == 0x1f && m_stream.next_in[1] == 0x8b;
    m_ended = !more || inflateReset(&m_stream) != Z_OK;
  }

  std::string_view m_packed;
  z_stream m_stream{};
  bool m_open = false;
  bool m_ended = false;
};

class Bzip2 : public PackedBytes::Unpacker {
 public:
  explicit Bzip2(std::string_view packed) : m_packed(packed) {
    m_open = BZ2_bzDecompressInit(&m_stream, 0, 0) == BZ_OK;
    broken = !m_open;
  }
  ~Bzip2() override {
    if (m_open)
      BZ2_bzDecompressEnd(&m_stream);
  }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  std::size_t read(char* to, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && !broken && !m_ended) {
      if (m_stream.avail_in == 0 && !m_packed.empty()) {
        const std::size_t piece = std::min(m_packed.size(), mostAtOnce);
        m_stream.next_in = const_cast<char*>(m_packed.data());
        m_stream.avail_in = unsigned(piece);
        m_packed.remove_prefix(piece);
      }
      m_stream.next_out = to + done;
      const std::size_t room = std::min(count - done, mostAtOnce);
      m_stream.avail_out = unsigned(room);
      const unsigned given = m_stream.avail_in;
      const int state = BZ2_bzDecompress(&m_stream);
      const std::size_t got = room - m_stream.avail_out;
      done += got;
      const bool stuck = got == 0 && given == m_stream.avail_in;
      broken = state != BZ_OK && state != BZ_STREAM_END;
      m_ended = state == BZ_STREAM_END || (state == BZ_OK && stuck);
    }
    return done;
  }

 private:
  std::string_view m_packed;
  bz_stream m_stream{};
  bool m_open = false;
  bool m_ended = false;
};

std::unique_ptr<PackedBytes::Unpacker> unpacker(std::string_view packed, Packing packing) {
  switch (packing) {
    case Packing::deflated:
      return std::make_unique<Deflated>(packed);
    case Packing::bzip2:
      return std::make_unique<Bzip2>(packed);
    case Packing::hex:
      return std::make_unique<Hex>(packed);
    case Packing::none:
      break;
  }
  return std::make_unique<Plain>(packed);
}

}  // namespace

PackedBytes::PackedBytes(std::string_view packed, Packing packing)
    : m_unpacker(unpacker(packed, packing)) {}
PackedBytes::~PackedBytes() = default;
PackedBytes::PackedBytes(PackedBytes&&) noexcept = default;
PackedBytes& PackedBytes::operator=(PackedBytes&&) noexcept = default;

std::size_t PackedBytes::read(char* to, std::size_t count) {
  return m_unpacker->read(to, count);
}

bool PackedBytes::skip(std::uint64_t count) {
  std::array<char, 16384> piece;
  while (count > 0) {
    const std::size_t wanted = std::size_t(std::min<std::uint64_t>(count, piece.size()));
    if (read(piece.data(), wanted) != wanted)
      return false;
    count -= wanted;
  }
  return true;
}

bool PackedBytes::broken() const {
  return m_unpacker->broken;
}

bool PackedBytes::cutOff() const {
  return m_unpacker->cutOff;
}

std::uint64_t mostUnpacked(std::uint64_t packed, Packing packing) {
  switch (packing) {
    case Packing::deflated:
      // A match of 258 bytes takes at least two bits.
      return packed * 1032;
    case Packing::bzip2:
      return std::numeric_limits<std::uint64_t>::max();
    case Packing::hex:
      return packed / 2;
    case Packing::none:
      break;
  }
  return packed;
}

}  // namespace sline::model
