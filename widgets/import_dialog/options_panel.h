// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/form/field.h"
#include "widgets/import_dialog/import_draft.h"

class QGridLayout;
class QLabel;

namespace sline::widgets {

/// Sets what applies to the whole import: frame and unit with what was found and why, smoothing,
/// decimation, repair.
class OptionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit OptionsPanel(ImportDraft& draft, QWidget* parent = nullptr);

 private:
  /// A field of the options and its control.
  struct Row {
    Field field;
    std::function<QVariant(const model::ImportOptions&)> read;
    std::function<void(model::ImportOptions&, const QVariant&)> write;
    QWidget* control = nullptr;
  };
  static std::vector<Row> rows();
  QWidget* controlOf(const char* id) const;
  QLabel* reason(const char* name);
  void place(QGridLayout& grid);
  void refresh();

  ImportDraft& m_draft;
  std::vector<Row> m_rows;
  QLabel* m_frameReason;
  QLabel* m_unitReason;
};

}  // namespace sline::widgets
