// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/progress_meter.h"

#include <algorithm>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
constexpr std::size_t atATime = 3;
}

void ProgressMeter::add(double amount, const std::string& what) {
  const std::lock_guard lock(m_mutex);
  m_done += amount;
  if (m_progress && !m_cancelled && !m_progress(float(std::min(1.0, m_done / m_total)), what))
    m_cancelled = true;
}

void forFewAtATime(const std::vector<std::size_t>& order, const ProgressMeter& meter,
                   const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  parallelFor(std::min(atATime, order.size()), 1, [&](std::size_t) {
    for (std::size_t i = next++; i < order.size() && !meter.cancelled(); i = next++)
      body(order[i]);
  });
}
}  // namespace sline::model
