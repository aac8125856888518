// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/export/export_rows.h"

namespace sline::widgets {

/// How wide, at least, the column is that says what controls are: the same in all forms, so that
/// controls stand beneath each other.
inline constexpr int captionWidth = 92;

/// Controls for rows of one part of the table, each named "export-" and the row's id. What is
/// chosen is written into the order at once.
class RowForm : public QWidget {
  Q_OBJECT
 public:
  /// The order must outlive it.
  RowForm(render::ExportOrder& order, std::vector<ExportRow> rows, QWidget* parent = nullptr);

  /// Those that the kind has; false where it has none.
  bool showFor(const QString& kind);

 signals:
  void changed();

 private:
  QWidget* control(const ExportRow& row, const RowSwitch& kind);
  QWidget* control(const ExportRow& row, const RowChoice& kind);
  QWidget* control(const ExportRow& row, const RowNumber& kind);
  QWidget* control(const ExportRow& row, const RowText& kind);
  void take(const ExportRow& row, const QVariant& value);

  render::ExportOrder& m_order;
  std::vector<ExportRow> m_rows;
  std::vector<std::vector<QWidget*>> m_widgets;  ///< of each row
};

}  // namespace sline::widgets
