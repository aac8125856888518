// SPDX-License-Identifier: Apache-2.0
// Memory of this process as Linux counts it.
#pragma once

namespace sline::test {

/// AddressSanitizer keeps freed memory back and slows everything down, so that peaks and times say
/// nothing there.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// MiB, now and at their highest; 0 where the system does not tell (/proc/self/status).
double residentMiB();
double peakResidentMiB();
/// Starts the peak anew from what is resident now, where the system allows it.
void resetPeak();

}  // namespace sline::test
