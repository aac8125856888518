// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "widgets/start/recovery_list.h"

namespace sline::widgets {

/// The list for when something else is open already. It closes when nothing is left in it, or
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
