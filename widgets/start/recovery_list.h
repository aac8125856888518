// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "model/scene_file/journal.h"

class QVBoxLayout;

namespace sline::widgets {

/// Lists what crashes have left: for each document its title, when the copy was made, its file, and
/// what can be done with it.
class RecoveryList : public QWidget {
  Q_OBJECT
 public:
  explicit RecoveryList(QWidget* parent = nullptr);
  void setFound(const std::vector<model::Recoverable>& found);

 signals:
  void recoverWanted(const sline::model::Recoverable& found);
  /// Tells that the user has confirmed the removal.
  void forgetWanted(const sline::model::Recoverable& found);

 private:
  QWidget* row(const model::Recoverable& found, std::size_t number);
  void askToForget(const model::Recoverable& found);

  QVBoxLayout* m_rows;
};

}  // namespace sline::widgets
