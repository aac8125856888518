// SPDX-License-Identifier: Apache-2.0
// Measures this process's memory as Linux counts it.
#pragma once

namespace sline::test {

/// Tells whether AddressSanitizer is at work. It keeps freed memory back and slows everything down,
/// so that peaks and times say nothing there.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// Return MiB, now and at their highest; 0 if the system does not tell (/proc/self/status).
double residentMiB();
double peakResidentMiB();
/// Returns the highest of any process that this one started and that has ended, MiB.
double childrenPeakMiB();
/// Restarts the peak from what is resident now, if the system allows it.
void resetPeak();

}  // namespace sline::test
