// SPDX-License-Identifier: Apache-2.0
// All that can be done in the window, in one table: menus, keys and help are made from it.
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

struct ActionRow {
  QString id;  ///< also the QAction's objectName
  QString text;
  QList<QKeySequence> keys;
  QString tip;
  const char* icon = nullptr;  ///< of widgets/theme/icons.h
};

/// In the order in which help lists them.
std::vector<ActionRow> actionRows();
/// What mouse and keys do in the list of structures beside these.
std::vector<ControlRow> listRows();

class WindowActions {
 public:
  /// Makes an action of each row and adds it to the window, so that its keys work.
  explicit WindowActions(QWidget& window);
  /// Makes them once more, in the language of now; those that were are gone.
  void remake(QWidget& window);
  /// Asserts that the table has it.
  QAction& operator[](const QString& id) const;

 private:
  std::map<QString, QAction*> m_actions;
};

}  // namespace sline::widgets
