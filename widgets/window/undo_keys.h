// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace sline::widgets {

class WindowActions;

/// Leads the keys of Undo and Redo to the scene wherever the keyboard is. Only a field in which a
/// text is being typed keeps them, as long as it has something to take back itself – or always,
/// where it holds nothing of the scene
/// (`ownUndo`).
class UndoKeys : public QObject {
  Q_OBJECT
 public:
  /// The window's shortcuts do the rest, but for windows beside it, where `actions` are called.
  UndoKeys(QWidget& window, const WindowActions& actions);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Returns the action whose keys were pressed; null for other keys.
  QAction* actionOf(QEvent& event) const;

  QWidget& m_window;
  const WindowActions& m_actions;
};

}  // namespace sline::widgets
