// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>
#include <string_view>

namespace sline::cli {

/// Shows one line on standard error that is overwritten as work goes on – on a terminal; in a pipe
/// it stays silent. May be called from any thread.
class Progress {
 public:
  Progress();
  /// Wipes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows how far the work is; `done` is in [0, 1].
  void show(double done, std::string_view what);
  /// Wipes the line and leaves a message that stays (on a terminal).
  void note(std::string_view message);
  void wipe();

 private:
  bool m_terminal = false;
  std::mutex m_mutex;
  std::string m_shown;
};

/// Prints "sline: warning: …" on standard error, in a pipe too.
void warn(std::string_view message);
/// Prints information on standard error in the same way.
void tell(std::string_view message);

}  // namespace sline::cli
