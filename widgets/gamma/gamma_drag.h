// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/session/session.h"

namespace sline::widgets {

/// A change of Γ by hand: shown at once, one undo step when it is let go, none where it is given
/// up.
class GammaDrag {
 public:
  explicit GammaDrag(Session& session) : m_session(session) {}

  void begin(NodeIds ids);
  void moveTo(Gamma gamma);
  void finish();
  void cancel();
  bool active() const { return !m_ids.empty(); }

 private:
  Session& m_session;
  NodeIds m_ids;
};

/// "Γ of left kidney", "Γ of 3 items": how such a change is called.
QString gammaStepName(const model::Scene& scene, const NodeIds& ids);

}  // namespace sline::widgets
