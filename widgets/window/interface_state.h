// SPDX-License-Identifier: Apache-2.0
// Keeps the state that only the controls have while they are made anew.
#pragma once

#include <QByteArray>
#include <QMainWindow>
#include <QPoint>
#include <QRect>
#include <QString>
#include <map>
#include <vector>

namespace sline::widgets {

/// Remembers where docks and toolbars lie, what is typed into boxes, how far lists are scrolled,
/// which control has the keyboard, and which windows of settings and help are open.
class InterfaceState {
 public:
  explicit InterfaceState(const QMainWindow& window);
  void restore(QMainWindow& window) const;

 private:
  /// A window that an action opens.
  struct Opened {
    QString action;
    QString name;
    QRect place;
    int page = -1;  ///< of its tabs or its list
    QString focus;
  };
  void remember(const QWidget& opened, const char* action);
  void reopen(QMainWindow& window, const Opened& opened) const;

  QByteArray m_places;
  QString m_focus;
  std::map<QString, QString> m_texts;  ///< by the boxes' names
  std::map<QString, QPoint> m_scrolled;
  std::vector<Opened> m_opened;
};

/// Removes docks, toolbars, menus, the status bar and the windows that actions have opened.
void clearControls(QMainWindow& window);

}  // namespace sline::widgets
