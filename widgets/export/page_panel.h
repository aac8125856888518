// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/export/export_draft.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace sline::widgets {

/// Sets the page's size: a paper by its name, or numbers typed in millimetres or pixels. The size
/// in the other unit is shown beneath.
class PagePanel : public QWidget {
  Q_OBJECT
 public:
  /// Edits the draft, which must outlive the panel.
  explicit PagePanel(ExportDraft& draft, QWidget* parent = nullptr);

  /// Shows the draft, which may be of another kind now.
  void refresh();

 signals:
  void changed();

 private:
  void place(QGridLayout& grid);
  QDoubleSpinBox* number(const char* name);
  void connectControls();
  void setSize(const glm::vec2& sizeMm);
  void typed();
  float millimetresPerUnit() const;

  ExportDraft& m_draft;
  QComboBox* m_preset;
  QPushButton* m_turn;
  QDoubleSpinBox* m_width;
  QDoubleSpinBox* m_height;
  QComboBox* m_unit;
  QLabel* m_dpiText;
  QDoubleSpinBox* m_dpi;
  QLabel* m_other;
};

}  // namespace sline::widgets
