// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QWidget;

namespace sline::widgets {

/// Handles F1 in dialogs, where the window's own actions are out of reach. There must be only one.
class HelpKey : public QObject {
  Q_OBJECT
 public:
  explicit HelpKey(QObject* parent);

  /// Opens the page about the widget, or shows it in the help that its window has already open.
  static void showHelp(QWidget& about);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace sline::widgets
