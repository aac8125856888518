// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/edit/look.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Changes looks by dragging: shown at once, one undo step when the drag ends, none when it is
/// cancelled.
class LookDrag {
 public:
  explicit LookDrag(Session& session) : m_session(session) {}

  void begin(NodeIds ids);
  void moveTo(const model::Style& look);
  /// Ends the drag; `what` names what is changed, such as "Line width".
  void finish(const QString& what);
  void cancel();
  bool active() const { return !m_ids.empty(); }

 private:
  Session& m_session;
  NodeIds m_ids;
};

/// Returns "Γ", the name of the value in every language.
QString gammaText();
/// Returns the name of a step that changes looks: "Line width of left kidney", "Line width of 3
/// items".
QString lookStepName(const QString& what, const model::Scene& scene, const NodeIds& ids);
/// Returns the name of a series: changes of one kind to the same items that follow each other
/// within a second are one step.
QString lookSeries(const QString& kind, const NodeIds& ids);

}  // namespace sline::widgets
