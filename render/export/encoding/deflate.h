// SPDX-License-Identifier: Apache-2.0
// Runs zlib's deflate on all cores.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sline::render {

/// Returns the bytes as one complete zlib stream.
std::string zlibStream(std::span<const std::byte> bytes);

/// Makes one zlib stream that grows; its parts are deflated at the same time, each knowing the 32
/// KiB before it.
class DeflateStream {
 public:
  DeflateStream();
  /// Returns the next part of the stream, in pieces of moderate length. `parts` together are the
  /// bytes that follow, side by side in memory.
  std::vector<std::string> add(std::span<const std::span<const std::byte>> parts);
  /// Returns the end of the stream.
  std::string finish() const;

 private:
  std::uint32_t m_checksum;
  std::vector<std::byte> m_window;
  bool m_begun = false;
};

}  // namespace sline::render
