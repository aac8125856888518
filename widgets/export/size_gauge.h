// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <optional>

#include "widgets/export/export_files.h"
#include "widgets/session/background_queue.h"

namespace sline::widgets {

/// Finds out in the background how large a file will be.
class SizeGauge : public QObject {
  Q_OBJECT
 public:
  explicit SizeGauge(QObject* parent = nullptr) : QObject(parent) {}

  /// Measures the file of that kind, given a small picture of its page; what was asked before is
  /// given up, unless it was the same.
  void measure(const QString& kind, const render::ExportPiece& file, const QImage& page);
  /// Returns the bytes of that file; 0 where they cannot be known, nothing where they are not known
  /// yet.
  std::optional<double> bytes(const QString& kind, const render::ExportPiece& file) const;
  /// Gives up what is being measured, and deletes itself when that has ended: whoever owned it need
  /// not wait.
  void retire();

 signals:
  void measured();

 private:
  QString m_kind;
  render::ExportPiece m_file;
  double m_bytes = 0.0;
  int m_asked = 0;
  int m_done = 0;
  bool m_retired = false;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
