// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/progress.h"

#include <algorithm>
#include <iostream>
#include <string>

#include "app/cli/files/flag_words.h"
#include "app/cli/files/names.h"
#include "model/disk/process.h"

namespace sline::cli {

Progress::Progress() : m_terminal(model::errorsGoToTerminal()) {}

Progress::~Progress() {
  wipe();
}

void Progress::show(double done, std::string_view what) {
  if (!m_terminal)
    return;
  const std::scoped_lock lock(m_mutex);
  const int percent = int(100.0 * std::clamp(done, 0.0, 1.0));
  std::string line = std::to_string(percent) + " % " + std::string(what.substr(0, 60));
  if (line == m_shown)
    return;
  m_shown = std::move(line);
  std::cerr << "\r\033[K" << m_shown << std::flush;
}

void Progress::note(std::string_view message) {
  if (!m_terminal)
    return;
  wipe();
  std::cerr << message << '\n';
}

void Progress::wipe() {
  const std::scoped_lock lock(m_mutex);
  if (!m_shown.empty())
    std::cerr << "\r\033[K" << std::flush;
  m_shown.clear();
}

void warn(std::string_view message) {
  std::cerr << "sline: warning: " << withFlags(onOneLine(std::string(message))) << '\n';
}

void tell(std::string_view message) {
  std::cerr << "sline: " << withFlags(std::string(message)) << '\n';
}

}  // namespace sline::cli
