// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTreeView>

#include "widgets/import_dialog/plan_tree_model.h"

namespace sline::widgets {

class NameOrFile;

/// Lists what would be imported: sorted by any column, filtered by name or file, with several rows
/// edited at once.
class PlanTree : public QTreeView {
  Q_OBJECT
 public:
  explicit PlanTree(ImportDraft& draft, QWidget* parent = nullptr);

  PlanTreeModel& tree() { return *m_model; }
  /// Shows the structures that have what is asked for (TypedWishes) in their names, files or
  /// groups.
  void setFilter(const QString& text);
  NodeIds selectedNodes() const;
  /// Returns the index of the node's row in the view's own model.
  QModelIndex indexOf(model::NodeId id, int column = PlanTreeModel::name) const;

 signals:
  void selectedNodesChanged();

 protected:
  /// Includes or leaves out the whole selection on Space.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void showAll();
  /// Selects those of the nodes, which are in ascending order, that are shown.
  void selectNodes(const NodeIds& ids);

  PlanTreeModel* m_model;
  NameOrFile* m_filtered;
  bool m_filtering = false;
};

}  // namespace sline::widgets
