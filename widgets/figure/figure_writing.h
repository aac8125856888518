// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>

#include "widgets/figure/figure_job.h"

class QProgressBar;
class QPushButton;

namespace sline::widgets {

/// Shows how far a figure has been written, with a button that stops it; hidden while nothing is.
class FigureWriting : public QWidget {
  Q_OBJECT
 public:
  explicit FigureWriting(QWidget* parent = nullptr);
  ~FigureWriting() override;

  /// Writes the file; not while another one is being written.
  void begin(FigureWork work, const std::filesystem::path& target);
  bool busy() const { return m_job != nullptr; }
  /// Stops writing; `ended` follows.
  void cancel();

 signals:
  /// Tells how it ended, in words; nothing is written any more.
  void ended(const QString& words);

 private:
  void end(const QString& words);

  QProgressBar* m_bar;
  QPushButton* m_cancel;
  std::unique_ptr<FigureJob> m_job;
};

}  // namespace sline::widgets
