// SPDX-License-Identifier: Apache-2.0
// Lists everything that can be done in the window in one table, from which menus, keys and help are
// made.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>
#include <map>
#include <vector>

#include "widgets/viewport/tools/mouse_preset.h"

class QAction;
class QWidget;

namespace sline::widgets {

/// The property of a field that keeps Undo and Redo for what is typed in it, even where nothing of
/// it is left to take back.
inline constexpr const char* ownUndo = "ownUndo";

struct ActionRow {
  QString id;  ///< also the QAction's objectName
  QString text;
  QList<QKeySequence> keys;
  QString tip;
  const char* icon = nullptr;  ///< a name of widgets/theme/icons.h
};

/// Returns the actions in the order in which help lists them.
std::vector<ActionRow> actionRows();
/// Returns what mouse and keys do in the list of structures besides the actions.
std::vector<ControlRow> listRows();

class WindowActions {
 public:
  /// Makes an action of each row and adds it to the window, so that its keys work.
  explicit WindowActions(QWidget& window);
  /// Replaces the actions by new ones in the current language.
  void remake(QWidget& window);
  /// Returns the action; asserts that the table has it.
  QAction& operator[](const QString& id) const;

 private:
  std::map<QString, QAction*> m_actions;
};

}  // namespace sline::widgets
