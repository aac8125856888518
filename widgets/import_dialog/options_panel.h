// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/import_dialog/import_draft.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;

namespace sline::widgets {

/// What holds for all that is imported: frame and unit with what was found and why, smoothing,
/// decimation, repair.
class OptionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit OptionsPanel(ImportDraft& draft, QWidget* parent = nullptr);

 private:
  QComboBox* combo(const char* name);
  QLabel* reason(const char* name);
  void place(QGridLayout& grid);
  void connectControls();
  void refresh();
  void change(const std::function<void(model::ImportOptions&)>& how);

  ImportDraft& m_draft;
  QComboBox* m_frame;
  QLabel* m_frameReason;
  QComboBox* m_unit;
  QLabel* m_unitReason;
  QComboBox* m_smoothing;
  QDoubleSpinBox* m_decimation;
  QCheckBox* m_repair;
  QCheckBox* m_overlay;
};

}  // namespace sline::widgets
