// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/event_watch.h"

#include <fcntl.h>
#include <unistd.h>

#include <QEvent>
#include <QMetaEnum>
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

namespace sline::test {

namespace {

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

/// Returns how long the thread was ready to run while no core was free; 0 if the kernel does not
/// say.
double waitedForCore() {
  static thread_local const int file = open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
  std::array<char, 128> text{};
  unsigned long long ran = 0;
  unsigned long long waited = 0;
  if (file < 0 || pread(file, text.data(), text.size() - 1, 0) <= 0 ||
      std::sscanf(text.data(), "%llu %llu", &ran, &waited) != 2)
    return 0.0;
  return double(waited) * 1e-6;
}

struct Times {
  double wall = milliseconds(CLOCK_MONOTONIC);
  double worked = milliseconds(CLOCK_THREAD_CPUTIME_ID);
  double waited = waitedForCore();
};

QString nameOf(const QObject& receiver, const QEvent& event) {
  const char* key = QMetaEnum::fromType<QEvent::Type>().valueToKey(int(event.type()));
  const QString kind = key ? QString::fromLatin1(key) : QString::number(int(event.type()));
  return kind + QStringLiteral(" of ") + QLatin1String(receiver.metaObject()->className());
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (m_depth > 0)
    return QApplication::notify(receiver, event);
  // The name is taken now, since the receiver may be gone afterwards.
  const QString what = nameOf(*receiver, *event);
  const Times before;
  ++m_depth;
  const bool handled = QApplication::notify(receiver, event);
  --m_depth;
  const Times after;
  const double wall = after.wall - before.wall;
  const double worked = after.worked - before.worked;
  m_costs.push_back(
      {what, wall, worked, std::max(0.0, wall - worked - (after.waited - before.waited))});
  return handled;
}

EventCost WatchedApplication::worst(double EventCost::*figure) const {
  const auto at = std::max_element(
      m_costs.begin(), m_costs.end(),
      [figure](const EventCost& a, const EventCost& b) { return a.*figure < b.*figure; });
  return at == m_costs.end() ? EventCost{} : *at;
}

QString WatchedApplication::report(std::size_t lines) const {
  std::vector<EventCost> dearest = m_costs;
  std::sort(dearest.begin(), dearest.end(), [](const EventCost& a, const EventCost& b) {
    return a.worked + a.stood > b.worked + b.stood;
  });
  dearest.resize(std::min(dearest.size(), lines));
  QString text = QStringLiteral("%1 events").arg(m_costs.size());
  for (const EventCost& cost : dearest)
    text += QStringLiteral("\n  %1: %2 ms at work, %3 ms held up, %4 ms in all")
                .arg(cost.what)
                .arg(cost.worked, 0, 'f', 1)
                .arg(cost.stood, 0, 'f', 1)
                .arg(cost.wall, 0, 'f', 1);
  return text;
}

}  // namespace sline::test
