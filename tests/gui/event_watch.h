// SPDX-License-Identifier: Apache-2.0
// Measures what each event costs the thread that handles it.
#pragma once

#include <QApplication>
#include <QString>
#include <cstdint>
#include <vector>

namespace sline::test {

/// Holds the cost of one event, with all that was done before its handler returned.
struct EventCost {
  QString what;  ///< kind of the event and class of its receiver
  /// Holds how often the thread asked for memory: its work as tests judge it, the same on every
  /// machine. In this window's work on structures, rows and texts a hundred thousand of them were
  /// 7 to 30 ms on a machine of 2026.
  std::uint64_t requests = 0;
  double wall = 0.0;    ///< milliseconds from beginning to end, for benchmarks
  double worked = 0.0;  ///< milliseconds of the thread's own CPU time, for benchmarks
};

/// An application that measures its events.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;

  void forget() { m_costs.clear(); }
  const std::vector<EventCost>& costs() const { return m_costs; }
  /// Returns the most requests of one event; 0 if there was none.
  std::uint64_t mostRequests() const;
  /// Returns "MouseMove of Viewport" and the like with their figures, the dearest first.
  QString report(std::size_t lines) const;

 private:
  std::vector<EventCost> m_costs;
  int m_depth = 0;
};

}  // namespace sline::test
