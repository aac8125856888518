// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace sline::cli {

/// While an Interruption exists, Ctrl+C and the signals that end a program only record that it is
/// to end: a file being written can then be given up, so that no half file stays. Afterwards the
/// program ends as it would have at once. A second such signal ends it without waiting. At most one
/// may exist at a time.
class Interruption {
 public:
  Interruption();
  /// Ends the program if a signal asked for that.
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool wanted() const;

 private:
  std::array<struct sigaction, 3> m_before;
};

}  // namespace sline::cli
