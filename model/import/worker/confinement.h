// SPDX-License-Identifier: Apache-2.0
// What a reading child gives up before it opens a file that nobody trusts.
#pragma once

#include <cstdint>

namespace sline::model {

struct ConfinementLimits {
  std::uint64_t memoryBytes = 0;  ///< of its own data, what it has mapped to write included
  std::uint64_t seconds = 0;      ///< of computing, on all cores together
};

/// How a child ends that wanted more memory than it may have.
inline constexpr int outOfMemoryStatus = 77;

/// From here on the process ends with its parent, keeps to the limits, leaves no core file, and the
/// kernel refuses it connections, other programs and looks into other processes (seccomp; where the
/// machine is of another kind than x86-64 and AArch64, the limits alone hold). Allocating more
/// than the limit with `new` ends it with `outOfMemoryStatus`.
void confineThisProcess(const ConfinementLimits& limits);

}  // namespace sline::model
