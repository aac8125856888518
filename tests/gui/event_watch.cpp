// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/event_watch.h"

#include <QEvent>
#include <QMetaEnum>
#include <algorithm>
#include <ctime>

#include "tests/support/memory_requests.h"

namespace sline::test {

namespace {

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

struct Times {
  double wall = milliseconds(CLOCK_MONOTONIC);
  double worked = milliseconds(CLOCK_THREAD_CPUTIME_ID);
  std::uint64_t requests = memoryRequests();
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
  m_costs.push_back({what, after.requests - before.requests, after.wall - before.wall,
                     after.worked - before.worked});
  return handled;
}

std::uint64_t WatchedApplication::mostRequests() const {
  std::uint64_t most = 0;
  for (const EventCost& cost : m_costs)
    most = std::max(most, cost.requests);
  return most;
}

QString WatchedApplication::report(std::size_t lines) const {
  std::vector<EventCost> dearest = m_costs;
  std::sort(dearest.begin(), dearest.end(),
            [](const EventCost& a, const EventCost& b) { return a.requests > b.requests; });
  dearest.resize(std::min(dearest.size(), lines));
  QString text = QStringLiteral("%1 events").arg(m_costs.size());
  for (const EventCost& cost : dearest)
    text += QStringLiteral("\n  %1: %2 requests, %3 ms at work, %4 ms in all")
                .arg(cost.what)
                .arg(cost.requests)
                .arg(cost.worked, 0, 'f', 1)
                .arg(cost.wall, 0, 'f', 1);
  return text;
}

}  // namespace sline::test
