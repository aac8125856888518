// SPDX-License-Identifier: Apache-2.0
// Makes structures from a scan: bounds chosen on its histogram, by number or by preset, with the
// result shown in slices at once.
#pragma once

#include <QWidget>
#include <vector>

#include "model/import/volumes/threshold_presets.h"
#include "widgets/import_dialog/import_draft.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace sline::widgets {

class IntensityRange;
struct ScanFigures;

class ThresholdPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ThresholdPanel(ImportDraft& draft, QWidget* parent = nullptr);

 private:
  void makePresets(QHBoxLayout& row);
  void makeFields(QGridLayout& grid);
  void connectControls();
  void refresh();
  void showScan();
  void choosePreset(const std::string& name);
  void setBounds(const model::IntensityBounds& bounds);
  void showSlices();
  void showMade();
  void addStructure();
  const ScanFigures* scan() const;

  ImportDraft& m_draft;
  QComboBox* m_scans;
  QLabel* m_about;
  IntensityRange* m_range;
  QLineEdit* m_name;
  QDoubleSpinBox* m_low;
  QDoubleSpinBox* m_high;
  QPushButton* m_add;
  QLabel* m_made;
  QCheckBox* m_keep;
  QLabel* m_slices;
  std::vector<QPushButton*> m_presets;
  const void* m_shown = nullptr;  ///< the volume the controls are set for
};

}  // namespace sline::widgets
