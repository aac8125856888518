// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/import_dialog/import_draft.h"
#include "widgets/session/display_names.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace sline::widgets {

/// Sets choices for the selected structures that differ from the others, and shows why they are as
/// they are.
class SelectionPanel : public QWidget {
  Q_OBJECT
 public:
  SelectionPanel(ImportDraft& draft, const DisplayNames& names, QWidget* parent = nullptr);
  /// Shows the structures; `structures` are those at or below `selected`.
  void show(const NodeIds& selected, const NodeIds& structures);

 private:
  using Change = std::function<void(model::StructureChoice&)>;
  /// Makes a combo box at least as wide as so many letters.
  QComboBox* combo(const char* name, const QString& label, int letters);
  void connectControls();
  void refresh();
  QString titleText() const;
  void chooseColour();
  void choose(const Change& change) { m_draft.choose(m_structures, change); }

  ImportDraft& m_draft;
  const DisplayNames& m_names;
  NodeIds m_selected;
  NodeIds m_structures;
  QLabel* m_title;
  QCheckBox* m_include;
  QComboBox* m_frame;
  QComboBox* m_unit;
  QComboBox* m_smoothing;
  QComboBox* m_decimation;
  QPushButton* m_colour;
  QLabel* m_details;
};

}  // namespace sline::widgets
