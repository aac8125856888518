// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeView>

#include "widgets/import_dialog/plan_tree_model.h"

class QSortFilterProxyModel;

namespace sline::widgets {

/// The list of what would be imported: sorted by any column, filtered by name or file, several rows
/// worked on at once.
class PlanTree : public QTreeView {
  Q_OBJECT
 public:
  explicit PlanTree(ImportDraft& draft, QWidget* parent = nullptr);

  PlanTreeModel& tree() { return *m_model; }
  /// Shows the structures whose names, files or groups contain the text.
  void setFilter(const QString& text);
  NodeIds selectedNodes() const;
  /// Of the row, in the view's own model.
  QModelIndex indexOf(model::NodeId id, int column = PlanTreeModel::name) const;

 signals:
  void selectedNodesChanged();

 protected:
  /// Space includes or leaves out all that is selected.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void showAll();

  PlanTreeModel* m_model;
  QSortFilterProxyModel* m_filtered;
};

}  // namespace sline::widgets
