// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/fingerprint.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "model/base/number_codes.h"

namespace sline::model {

namespace {
/// The polynomial is that of CRC-32 of IEEE 802.3, bits reflected, byte by byte (Sarwate,
/// "Computation of cyclic redundancy checks via table look-up", CACM 31(8), 1988) or eight bytes at
/// a time (Kounavis and Berry, "Novel table lookup-based algorithms for high-performance CRC
/// generation", IEEE Transactions on Computers 57(11), 2008).
constexpr std::uint32_t polynomial = 0xedb88320u;
constexpr std::size_t slices = 8;
using Table = std::array<std::uint32_t, 256>;

/// The table at index i is for a byte that i bytes follow.
constexpr std::array<Table, slices> remainders() {
  std::array<Table, slices> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit)
      rest = rest >> 1 ^ ((rest & 1) != 0 ? polynomial : 0);
    tables[0][byte] = rest;
  }
  for (std::size_t slice = 1; slice < slices; ++slice)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[slice - 1][byte];
      tables[slice][byte] = before >> 8 ^ tables[0][before & 0xff];
    }
  return tables;
}

class Checksum {
 public:
  void add(std::string_view bytes) {
    static constexpr std::array<Table, slices> tables = remainders();
    m_bytes += bytes.size();
    for (; bytes.size() >= slices; bytes.remove_prefix(slices)) {
      const std::uint32_t low = m_rest ^ wordAt(bytes, 0);
      const std::uint32_t high = wordAt(bytes, 4);
      m_rest = 0;
      for (std::size_t i = 0; i < 4; ++i)
        m_rest ^= tables[7 - i][low >> 8 * i & 0xff] ^ tables[3 - i][high >> 8 * i & 0xff];
    }
    for (const char c : bytes)
      m_rest = m_rest >> 8 ^ tables[0][(m_rest ^ static_cast<unsigned char>(c)) & 0xff];
  }
  Fingerprint fingerprint() const { return {m_bytes, ~m_rest}; }

 private:
  std::uint32_t m_rest = 0xffffffffu;
  std::uint64_t m_bytes = 0;
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
}  // namespace

Fingerprint fingerprintOf(std::string_view bytes) {
  Checksum sum;
  sum.add(bytes);
  return sum.fingerprint();
}

Result<Fingerprint> fingerprintOfFile(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, CloseFile> handle(std::fopen(file.string().c_str(), "rb"));
  std::vector<char> piece(std::size_t(1) << 16);
  Checksum sum;
  std::size_t got = 0;
  while (handle && (got = std::fread(piece.data(), 1, piece.size(), handle.get())) > 0)
    sum.add({piece.data(), got});
  if (!handle || std::ferror(handle.get()) != 0)
    return Error{.file = file.string(),
                 .reason = "it cannot be read: " + std::generic_category().message(errno),
                 .remedy = "Check the path and its permissions"};
  return sum.fingerprint();
}

}  // namespace sline::model
