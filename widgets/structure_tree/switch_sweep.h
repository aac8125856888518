// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/session/session.h"

namespace sline::widgets {

/// Eyes or locks set by one press and whatever the mouse then passes over: shown at once, one undo
/// step when it is let go, none where it is given up.
class SwitchSweep {
 public:
  enum class Switch { eye, lock };

  explicit SwitchSweep(Session& session) : m_session(session) {}

  /// All of them come to be what the one that was pressed is not: shown, or locked.
  void begin(Switch what, model::NodeId pressed, NodeIds ids);
  /// One more, set as the first were.
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
