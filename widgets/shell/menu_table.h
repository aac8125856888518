// SPDX-License-Identifier: Apache-2.0
// Menus and toolbar as tables over the table of actions.
#pragma once

#include <QString>
#include <map>
#include <vector>

class QMainWindow;
class QMenu;
class QToolBar;

namespace sline::widgets {

class WindowActions;

struct MenuRow {
  QString id;  ///< also the QMenu's objectName
  QString text;
  /// Ids of actions; "" draws a line; ">id" is another row as a submenu. Rows that no other names
  /// stand in the menu bar.
  std::vector<QString> entries;
};

std::vector<MenuRow> menuRows();
/// Ids of actions; "" draws a line.
std::vector<QString> toolRows();

class WindowMenus {
 public:
  /// Fills the window's menu bar.
  WindowMenus(QMainWindow& window, const WindowActions& actions);
  /// For entries that are not in the table, such as the scene's own views. Asserts that there is
  /// one of that id.
  QMenu& operator[](const QString& id) const;

 private:
  std::map<QString, QMenu*> m_menus;
};

QToolBar* makeToolBar(QMainWindow& window, const WindowActions& actions);

}  // namespace sline::widgets
