// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QWidget;

namespace sline::widgets {

/// F1 in dialogs, where the window's own actions are out of reach. There is to be one of it.
class HelpKey : public QObject {
  Q_OBJECT
 public:
  explicit HelpKey(QObject* parent);

  /// Opens the page about the widget, or goes to it in the help that its window has open.
  static void showHelp(QWidget& about);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace sline::widgets
