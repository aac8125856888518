// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/sections/new_section.h"
#include "widgets/shell/window_actions.h"
#include "widgets/viewport/tools/tool.h"

class QMenu;
class QToolButton;

namespace sline::widgets {

/// Runs the actions of section planes: one section along each axis of the body, through the middle
/// of what is shown, and any number of sections by menus; each is an undo step.
class SectionActions : public QObject {
  Q_OBJECT
 public:
  SectionActions(Session& session, const ViewControl& view, const WindowActions& actions,
                 QObject* parent);

  /// Fills the menu with entries that add a section of each kind, otherwise as the wish says.
  void fill(QMenu& menu, const SectionWish& wish);
  /// Gives the button its menu, which adds sections of the whole scene or of the selection.
  void fillAddMenu(QToolButton& button);

 signals:
  /// Tells that a section could not be added.
  void refused(const sline::Error& error);

 private:
  QAction& actionOf(int axis) const;
  /// Adds the section along the axis, or removes it where there is one.
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
