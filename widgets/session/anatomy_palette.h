// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QListWidget>
#include <functional>

namespace sline::widgets {

/// Lists the colours that structures have by convention (model/anatomy), by name.
class AnatomyPalette : public QListWidget {
  Q_OBJECT
 public:
  /// `shown` returns a structure's name as it appears on screen.
  explicit AnatomyPalette(const std::function<QString(const std::string&)>& shown,
                          QWidget* parent = nullptr);

 signals:
  void chosen(const QColor& colour);
};

}  // namespace sline::widgets
