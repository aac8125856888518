// SPDX-License-Identifier: Apache-2.0
// Says before surfaces fill the machine's memory that they would, because a machine that swaps
// seems to hang.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "model/base/result.h"

namespace sline::model {

/// What a triangle takes at least, with all that is made of it until it is drawn; measured from the
/// import of a surface of 17 million triangles to its first picture (`sline-bench`).
inline constexpr std::uint64_t bytesPerTriangle = 130;

/// Returns how many bytes this process may still take before the system swaps or ends it; 0 where
/// the system does not tell.
std::uint64_t availableMemory();

/// Returns the size in gigabytes with one decimal.
std::string gigabytes(std::uint64_t bytes);

/// Counts the triangles of a piece of work against the memory that was available when it began; any
/// thread may call it.
class MemoryBudget {
 public:
  /// `bytes`: what may be taken; 0: what is available.
  explicit MemoryBudget(std::uint64_t bytes = 0) : m_bytes(bytes > 0 ? bytes : availableMemory()) {}
  /// Takes room for a surface. Where there is too little nothing is taken, and the error says how
  /// much would be needed.
  Status claim(std::uint64_t triangles);

 private:
  std::uint64_t m_bytes;
  std::atomic<std::uint64_t> m_taken = 0;
};

}  // namespace sline::model
