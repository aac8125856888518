// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QTreeWidget;

namespace sline::widgets {

/// What the mouse and the keys do, by menus, with a filter.
class ControlsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ControlsDialog(QWidget* parent = nullptr);

 private:
  void fill();
  /// Hides the rows that do not contain the text, and headings without rows.
  void filter(const QString& text);

  QTreeWidget* m_rows;
};

}  // namespace sline::widgets
