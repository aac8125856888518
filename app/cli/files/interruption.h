// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace sline::cli {

/// While there is one, Ctrl+C and the signals that end a program only say that it is to end: what
/// is being written can be given up, so that no half file stays. Then the program ends as it would
/// have at once. A second such signal ends it without waiting. At most one at a time.
class Interruption {
 public:
  Interruption();
  /// Ends the program where that was asked for.
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool wanted() const;

 private:
  std::array<struct sigaction, 3> m_before;
};

}  // namespace sline::cli
