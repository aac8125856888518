// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "widgets/session/session.h"

class QWidget;

namespace sline::widgets {

class FigureDialog;
class WindowActions;

/// Runs the action that composes figures of the scene's views. It outlives the window's controls.
class FigureActions : public QObject {
  Q_OBJECT
 public:
  /// Connects the parts, all of which must outlive it.
  FigureActions(Session& session, const WindowActions& actions, QWidget& window);
  ~FigureActions() override;

  /// Connects to the window's new actions after they have been replaced.
  void controlsRemade();

 private:
  void showState();
  void showDialog();

  Session& m_session;
  const WindowActions& m_actions;
  QWidget& m_window;
  QPointer<FigureDialog> m_dialog;
  int m_opening = 0;  ///< of the document that the dialog was made of
};

}  // namespace sline::widgets
