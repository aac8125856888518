// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace sline::widgets {

/// What the program is, and on what it runs: text that can be copied into a report of a fault.
class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  /// `driver`: OpenGL's, as it calls itself.
  explicit AboutDialog(const QString& driver, QWidget* parent = nullptr);
};

}  // namespace sline::widgets
