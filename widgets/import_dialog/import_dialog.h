// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "widgets/import_dialog/import_draft.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace sline::widgets {

class PlanTree;
class ThresholdPanel;
class SelectionPanel;

/// Shows what an import would do and lets it be changed: frame and unit and, for each structure,
/// whether it is imported, its name, colour, smoothing and decimation. What is left out is listed
/// with the reason. Reads in the background as soon as it is made; the scene is not touched.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  /// Begins with the plan, of which inputs are enough; `intoScene` tells whether there is an open
  /// scene to add to. The names are those of colours and must outlive the dialog.
  ImportDialog(const DisplayNames& names, model::ImportPlan plan, bool intoScene,
               QWidget* parent = nullptr);
  ~ImportDialog() override;

  ImportDraft& draft() { return m_draft; }

 signals:
  /// Tells that the dialog has closed itself and the plan is to become a document of its own, or
  /// part of the open one.
  void importWanted(const sline::model::ImportPlan& plan);
  void addWanted(const sline::model::ImportPlan& plan);

 private:
  QWidget* makeStructures();
  QWidget* makeLeftOut();
  QWidget* makeButtons();
  QWidget* makeUnitButtons();
  void connectDraft();
  void showState();
  void showPlan();
  void showLeftOut();
  void showScans();
  void fitRows();
  /// Shows what speaks against a unit, with a button that takes the likelier one.
  void showUnitDoubt();
  void chooseUnit(float millimetres);
  void give(void (ImportDialog::*wanted)(const model::ImportPlan&));

  const DisplayNames& m_names;
  ImportDraft m_draft;
  bool m_intoScene;
  QString m_failure;
  QLabel* m_summary;
  QLabel* m_doubt;
  QPushButton* m_takeUnit;
  QPushButton* m_keepUnit;
  QTabWidget* m_tabs;
  PlanTree* m_tree = nullptr;
  SelectionPanel* m_selection = nullptr;
  ThresholdPanel* m_thresholds = nullptr;
  QTableWidget* m_leftOut = nullptr;
  QLabel* m_state = nullptr;
  QProgressBar* m_progress = nullptr;
  QPushButton* m_import = nullptr;
  QPushButton* m_add = nullptr;
};

}  // namespace sline::widgets
