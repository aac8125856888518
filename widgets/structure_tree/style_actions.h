// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "model/scene/style.h"
#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

namespace sline::widgets {

/// Carries the style of one structure to others: by the clipboard, or by pointing at the one whose
/// style is wanted.
class StyleActions : public QObject {
  Q_OBJECT
 public:
  StyleActions(Session& session, const WindowActions& actions, QObject* parent);
  ~StyleActions() override;

 protected:
  /// Escape leaves waiting, wherever the keyboard is.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void copy();
  void paste(bool withColour);
  /// Gives the nodes the whole look as one undo step.
  void give(const NodeIds& ids, model::Style look, bool withColour, const QString& name);
  /// Begins to wait for another structure to be selected, or no longer.
  void wait(bool wanted);
  void selected();
  void showState();

  Session& m_session;
  const WindowActions& m_actions;
  NodeIds m_waiting;  ///< to be made like what is selected next
};

}  // namespace sline::widgets
