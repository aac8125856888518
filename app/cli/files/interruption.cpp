// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/interruption.h"

#include <iostream>

namespace sline::cli {

namespace {

constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};

/// A handler may touch nothing but this global.
volatile std::sig_atomic_t received = 0;

void receive(int signal) {
  received = signal;
}

}  // namespace

Interruption::Interruption() : m_before{} {
  received = 0;
  struct sigaction action {};
  action.sa_handler = receive;
  // The handler acts once. Calls that wait, for a pipe's reader perhaps, do not go on.
  action.sa_flags = int(SA_RESETHAND);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &m_before[i]);
    // Signals that the program was started to ignore stay ignored (nohup).
    if (m_before[i].sa_handler != SIG_IGN)
      sigaction(signals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals.size(); ++i)
    sigaction(signals[i], &m_before[i], nullptr);
  if (received == 0)
    return;
  std::cout.flush();
  std::raise(received);
}

bool Interruption::wanted() const {
  return received != 0;
}

}  // namespace sline::cli
