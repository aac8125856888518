// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

#include "widgets/export/export_files.h"

namespace sline::widgets {

/// Finds out in the background what a file would say of its picture if nobody said anything.
class AltTextHint : public QObject {
  Q_OBJECT
 public:
  explicit AltTextHint(QObject* parent = nullptr);

  /// Asks for that file; what was asked before is not answered any more.
  void ask(const render::ExportPiece& file);

 signals:
  void told(const QString& text);

 private:
  void find();

  render::ExportPiece m_file;
  QTimer m_pause;  ///< while choices follow each other
  int m_asked = 0;
};

}  // namespace sline::widgets
