// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"

class QWidget;

namespace sline::widgets {

class ComparisonDialog;
class Viewport;
class WindowActions;

/// Runs the action that compares techniques, for what is selected or else for all that is visible.
/// It outlives the window's controls.
class ComparisonActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    Session& session;
    const WindowActions& actions;
    Viewport& viewport;
  };
  /// Connects the parts, all of which must outlive it.
  ComparisonActions(const Context& context, QWidget& window);
  ~ComparisonActions() override;

  /// Connects to the window's new actions after they have been replaced.
  void controlsRemade();

 private:
  void showState();
  void showDialog();

  Session& m_session;
  const WindowActions& m_actions;
  Viewport& m_viewport;
  QWidget& m_window;
  BackgroundQueue m_queue;  ///< draws sheets
  QPointer<ComparisonDialog> m_dialog;
};

}  // namespace sline::widgets
