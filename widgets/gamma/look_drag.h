// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/edit/moved_look.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Changes a number of looks by dragging: shown at once, one undo step when the drag ends, none
/// when it is cancelled. Structures that differ keep their differences, unless the drag makes them
/// equal.
class LookDrag {
 public:
  LookDrag(Session& session, const model::LookNumber& number)
      : m_session(session), m_number(number) {}

  struct Start {
    NodeIds ids;
    float from = 0.0f;    ///< the number that the handle shows for them all
    bool levels = false;  ///< they become equal
  };
  void begin(Start start);
  /// Moves the handle there, or as far as the differences allow, which is said beside the mouse.
  void moveTo(float number);
  /// Ends the drag; `what` names what is changed, such as "Line width".
  void finish(const QString& what);
  void cancel();
  bool active() const { return !m_start.ids.empty(); }

 private:
  Session& m_session;
  model::LookNumber m_number;
  Start m_start;
  bool m_held = false;  ///< the differences have kept the handle from where the mouse is
};

/// Returns "Γ", the name of the value in every language.
QString gammaText();
/// Returns Γ as a number of a look.
model::LookNumber gammaNumber();
/// Returns what a slider does with values that differ, for its tool tip.
QString differencesText();
/// Returns the name of a step that changes looks: "Line width of left kidney", "Line width of 3
/// items".
QString lookStepName(const QString& what, Session& session, const NodeIds& ids);
/// Returns the name of a series: changes of one kind to the same items that follow each other
/// within a second are one step.
QString lookSeries(const QString& kind, const NodeIds& ids);

}  // namespace sline::widgets
