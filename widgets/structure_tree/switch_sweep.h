// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/session/session.h"

namespace sline::widgets {

/// Switches eyes or locks by one press and over the rows that the mouse then passes: shown at once,
/// one undo step on release, none if it is cancelled.
class SwitchSweep {
 public:
  enum class Switch { eye, lock };

  explicit SwitchSweep(Session& session) : m_session(session) {}

  /// Begins a sweep that gives all of them the opposite of the pressed node's state: shown or
  /// hidden, locked or open.
  void begin(Switch what, model::NodeId pressed, NodeIds ids);
  /// Adds one more, set as the first were.
  void add(model::NodeId id);
  void finish();
  void cancel();
  bool active() const { return !m_ids.empty(); }
  Switch what() const { return m_what; }

 private:
  void show();

  Session& m_session;
  Switch m_what = Switch::eye;
  bool m_on = false;
  NodeIds m_ids;
};

}  // namespace sline::widgets
