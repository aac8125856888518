// SPDX-License-Identifier: Apache-2.0
// Confines a reading child before it opens a file that is not trusted.
#pragma once

#include <cstdint>

namespace sline::model {

struct ConfinementLimits {
  std::uint64_t memoryBytes = 0;  ///< its own data, including writable mappings
  std::uint64_t seconds = 0;      ///< computing time, on all cores together
};

/// The exit status of a child that wanted more memory than it may have.
inline constexpr int outOfMemoryStatus = 77;

/// Confines the process: from here on it ends with its parent, keeps to the limits, leaves no core
/// file, and the kernel refuses it connections, other programs and looks into other processes
/// (seccomp; where the machine is of another kind than x86-64 and AArch64, the limits alone hold).
/// Allocating more than the limit with `new` ends it with `outOfMemoryStatus`.
void confineThisProcess(const ConfinementLimits& limits);

}  // namespace sline::model
