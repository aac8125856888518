// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

class QLabel;
class QToolButton;

namespace sline::widgets {

/// Chooses which of several files is looked at: one back, its name and number, one on. It is hidden
/// for a single file.
class FilePager : public QWidget {
  Q_OBJECT
 public:
  explicit FilePager(QWidget* parent = nullptr);

  /// Sets the files in their order; the current number stays while there are as many files.
  void setFiles(std::vector<std::filesystem::path> files);
  std::size_t index() const { return m_index; }

 signals:
  /// Tells that another file is to be looked at.
  void turned();

 private:
  void turnTo(std::size_t index);
  void showIndex();

  QToolButton* m_back;
  QLabel* m_text;
  QToolButton* m_on;
  std::vector<std::filesystem::path> m_files;
  std::size_t m_index = 0;
};

}  // namespace sline::widgets
