// SPDX-License-Identifier: Apache-2.0
// Lists menus and toolbar as tables over the table of actions.
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
  /// Holds ids of actions; "" draws a line; ">id" is another row as a submenu. Rows that no other
  /// row names stand in the menu bar.
  std::vector<QString> entries;
};

std::vector<MenuRow> menuRows();
/// Returns the ids of the toolbar's actions; "" draws a line.
std::vector<QString> toolRows();

class WindowMenus {
 public:
  /// Fills the window's menu bar.
  WindowMenus(QMainWindow& window, const WindowActions& actions);
  /// Returns the menu of that id, for entries that are not in the table, such as the scene's own
  /// views. Asserts that there is one.
  QMenu& operator[](const QString& id) const;

 private:
  std::map<QString, QMenu*> m_menus;
};

QToolBar* makeToolBar(QMainWindow& window, const WindowActions& actions);

}  // namespace sline::widgets
