// SPDX-License-Identifier: Apache-2.0
// Measures what each event costs the thread that handles it.
#pragma once

#include <QApplication>
#include <QString>
#include <vector>

namespace sline::test {

/// Holds the cost in milliseconds of one event, with all that was done before its handler returned.
struct EventCost {
  QString what;         ///< kind of the event and class of its receiver
  double wall = 0.0;    ///< from beginning to end
  double worked = 0.0;  ///< the thread's own CPU time
  /// Holds the time neither at work nor waiting for a core: held up by a lock, another thread or
  /// the display.
  double stood = 0.0;
};

/// An application that measures its events. Times of the thread are the kernel's, so that other
/// programs on the machine, which only make the thread wait for a core, do not count.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;

  void forget() { m_costs.clear(); }
  const std::vector<EventCost>& costs() const { return m_costs; }
  /// Returns the event with the largest figure of the kind asked for; all zero if there was none.
  EventCost worst(double EventCost::*figure) const;
  /// Returns "MouseMove of Viewport" and the like with their figures, the dearest first.
  QString report(std::size_t lines) const;

 private:
  std::vector<EventCost> m_costs;
  int m_depth = 0;
};

}  // namespace sline::test
