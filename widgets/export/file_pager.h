// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QToolButton;

namespace sline::widgets {

/// Chooses which of several files or pages is looked at: one back, its name and number, one on. It
/// is hidden for a single one.
class FilePager : public QWidget {
  Q_OBJECT
 public:
  explicit FilePager(QWidget* parent = nullptr);

  /// Sets the names in their order; the current number stays while there are as many.
  void setNames(const QStringList& names);
  std::size_t index() const { return m_index; }

 signals:
  /// Tells that another one is to be looked at.
  void turned();

 private:
  void turnTo(std::size_t index);
  void showIndex();

  QToolButton* m_back;
  QLabel* m_text;
  QToolButton* m_on;
  QStringList m_names;
  std::size_t m_index = 0;
};

}  // namespace sline::widgets
