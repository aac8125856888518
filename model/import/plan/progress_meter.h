// SPDX-License-Identifier: Apache-2.0
// Tells how far an import has come, and runs a few pieces of work at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "model/import/plan/import.h"

namespace sline::model {

/// The work of smoothing or decimating a triangle, where reading a byte takes 1.
inline constexpr double workPerTriangle = 6.0;

/// Counts finished work and asks the user's function whether to go on; any thread may call it.
class ProgressMeter {
 public:
  ProgressMeter(const ImportProgress& progress, double total)
      : m_progress(progress), m_total(total) {}
  void add(double amount, const std::string& what);
  /// Asks in the middle of a long piece of work; returns false to give up.
  bool goesOn(const std::string& what) {
    add(0.0, what);
    return !m_cancelled;
  }
  bool cancelled() const { return m_cancelled; }

 private:
  const ImportProgress& m_progress;
  double m_total;
  std::mutex m_mutex;
  double m_done = 0.0;
  std::atomic<bool> m_cancelled = false;
};

/// Calls body(i) for i in `order`, only a few at a time, so that memory stays bounded; stops early
/// where the meter says so.
void forFewAtATime(const std::vector<std::size_t>& order, const ProgressMeter& meter,
                   const std::function<void(std::size_t)>& body);

}  // namespace sline::model
