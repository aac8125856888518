// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "widgets/start/recovery_list.h"

namespace sline::widgets {

/// Shows the list while something else is open already. It closes when the list is empty, or
/// something was recovered, and deletes itself.
class RecoveryDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RecoveryDialog(QWidget* parent = nullptr);
  void setFound(const std::vector<model::Recoverable>& found);

 signals:
  void recoverWanted(const sline::model::Recoverable& found);
  void forgetWanted(const sline::model::Recoverable& found);

 private:
  RecoveryList* m_list;
};

}  // namespace sline::widgets
