// SPDX-License-Identifier: Apache-2.0
// Unpacks bytes as files store them, piece by piece: whatever the packed bytes claim to hold, only
// the piece asked for is in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace sline::model {

enum class Packing {
  none,
  deflated,  ///< gzip (several members in a row, too) or zlib
  bzip2,
  hex  ///< pairs of hexadecimal digits, white space between them
};

class PackedBytes {
 public:
  /// `packed` must outlive this object.
  PackedBytes(std::string_view packed, Packing packing);
  ~PackedBytes();
  PackedBytes(PackedBytes&&) noexcept;
  PackedBytes& operator=(PackedBytes&&) noexcept;

  /// Unpacks the next `count` bytes to `to`; returns fewer only where the data end or cannot be
  /// unpacked any further.
  std::size_t read(char* to, std::size_t count);
  /// Passes over `count` bytes; returns true if there were that many.
  bool skip(std::uint64_t count);
  /// Tells whether the packed bytes are not what they should be, rather than at their end.
  bool broken() const;
  /// Tells whether deflated bytes end in the middle of their content.
  bool cutOff() const;

  struct Unpacker;

 private:
  std::unique_ptr<Unpacker> m_unpacker;
};

/// Returns the most that packed bytes can hold, by the best ratio the method can reach. bzip2 packs
/// long runs almost without limit, so that this says little about it.
std::uint64_t mostUnpacked(std::uint64_t packed, Packing packing);

/// Returns the most bytes to which so many packed bytes of a surface may be unpacked: far more than
/// any surface packs by, and little enough that no small file fills the memory.
constexpr std::uint64_t mostOfSurface(std::uint64_t packed) {
  return (std::uint64_t(64) << 20) + 64 * packed;
}

/// Tells whether the bytes begin as those of gzip do.
inline bool beginsLikeGzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

}  // namespace sline::model
