// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <initializer_list>
#include <string>
#include <string_view>

#include "render/gpu/device.h"
#include "render/picture/picture.h"

namespace sline::render {

/// Sums up where time goes, phase by phase.
class Stopwatch {
 public:
  Stopwatch() : m_start(Clock::now()), m_last(m_start) {}

  /// Divides the time since the last phase ended between lines and passes of the processor, which
  /// ran side by side, by their shares.
  struct Share {
    std::string_view name;
    double share;
  };
  void shared(double lines, std::initializer_list<Share> passes) {
    const double milliseconds = lap();
    m_timings.lines += lines * milliseconds;
    for (const Share& pass : passes)
      add(pass.name, pass.share * milliseconds);
  }
  /// Counts the time since the last phase ended as spent on this pass; waits for the GPU, if there
  /// is one.
  void pass(gpu::Device* device, std::string_view name) {
    if (device)
      device->finish();
    add(name, lap());
  }
  PictureTimings done() {
    m_timings.total = between(m_start, Clock::now());
    return m_timings;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double between(Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double, std::milli>(b - a).count();
  }
  void add(std::string_view name, double milliseconds) {
    for (PictureTimings::Pass& p : m_timings.passes)
      if (p.name == name) {
        p.milliseconds += milliseconds;
        return;
      }
    m_timings.passes.push_back({std::string(name), milliseconds});
  }
  double lap() {
    const Clock::time_point now = Clock::now();
    const double milliseconds = between(m_last, now);
    m_last = now;
    return milliseconds;
  }

  Clock::time_point m_start;
  Clock::time_point m_last;
  PictureTimings m_timings;
};

}  // namespace sline::render
