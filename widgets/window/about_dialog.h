// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace sline::widgets {

/// Tells what the program is and what it runs on, as text that can be copied into a bug report.
class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  /// Makes the dialog; `driver` is OpenGL's own name for itself.
  explicit AboutDialog(const QString& driver, QWidget* parent = nullptr);
};

}  // namespace sline::widgets
