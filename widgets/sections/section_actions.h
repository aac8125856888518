// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/sections/new_section.h"
#include "widgets/shell/window_actions.h"
#include "widgets/viewport/tools/tool.h"

class QMenu;
class QToolButton;

namespace sline::widgets {

/// What the actions of section planes do: one section along each axis of the body, through the
/// middle of what is shown, and as many as wanted by menus; each is an undo step.
class SectionActions : public QObject {
  Q_OBJECT
 public:
  SectionActions(Session& session, const ViewControl& view, const WindowActions& actions,
                 QObject* parent);

  /// Entries that add a section of each kind as the wish says else.
  void fill(QMenu& menu, const SectionWish& wish);
  /// The menu that adds sections, of the whole scene or of what is selected.
  void fillAddMenu(QToolButton& button);

 signals:
  /// A section could not be added.
  void refused(const sline::Error& error);

 private:
  QAction& actionOf(int axis) const;
  /// Adds the section along the axis, or takes it away where there is one.
  void toggle(int axis);
  void add(const SectionWish& wish);
  void flip();
  void remove();
  void showState();

  Session& m_session;
  const ViewControl& m_view;
  const WindowActions& m_actions;
};

}  // namespace sline::widgets
