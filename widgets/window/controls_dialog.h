// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "widgets/viewport/tools/mouse_preset.h"

class QTreeWidget;

namespace sline::widgets {

/// Lists what the mouse and the keys do, by menus, with a filter.
class ControlsDialog : public QDialog {
  Q_OBJECT
 public:
  /// Makes the dialog; `mouse` holds what mouse and keys do in the picture.
  explicit ControlsDialog(const std::vector<ControlRow>& mouse, QWidget* parent = nullptr);

 private:
  void fill(const std::vector<ControlRow>& mouse);
  /// Hides the rows that do not contain the text, and headings without rows.
  void filter(const QString& text);

  QTreeWidget* m_rows;
};

}  // namespace sline::widgets
