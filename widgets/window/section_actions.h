// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/session/session.h"
#include "widgets/window/window_actions.h"

namespace sline::widgets {

class Viewport;

/// What the actions of section planes do: one section along each axis of the body, through the
/// middle of what is shown, each an undo step.
class SectionActions : public QObject {
  Q_OBJECT
 public:
  SectionActions(Session& session, const Viewport& viewport, const WindowActions& actions,
                 QObject* parent);

 private:
  QAction& actionOf(int axis) const;
  /// Adds the section along the axis, or takes it away where there is one.
  void toggle(int axis);
  void flip();
  void remove();
  void showState();

  Session& m_session;
  const Viewport& m_viewport;
  const WindowActions& m_actions;
};

}  // namespace sline::widgets
