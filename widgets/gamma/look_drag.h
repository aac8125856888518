// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/edit/look.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// A change of looks by hand: shown at once, one undo step when it is let go, none where it is
/// given up.
class LookDrag {
 public:
  explicit LookDrag(Session& session) : m_session(session) {}

  void begin(NodeIds ids);
  void moveTo(const model::Style& look);
  /// `what` is changed, such as "Line width".
  void finish(const QString& what);
  void cancel();
  bool active() const { return !m_ids.empty(); }

 private:
  Session& m_session;
  NodeIds m_ids;
};

/// "Γ", as what is changed is called in every language.
QString gammaText();
/// "Line width of left kidney", "Line width of 3 items": how a change of that kind is called.
QString lookStepName(const QString& what, const model::Scene& scene, const NodeIds& ids);
/// Changes of one kind to the same items that follow each other within a second are one.
QString lookSeries(const QString& kind, const NodeIds& ids);

}  // namespace sline::widgets
