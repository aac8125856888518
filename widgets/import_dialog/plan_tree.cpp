// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/plan_tree.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QSortFilterProxyModel>
#include <algorithm>

namespace sline::widgets {

namespace {

/// Filters by names and files; the other columns are only sorted.
class NameOrFile : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const auto contains = [&](int column) {
      return sourceModel()
          ->index(row, column, parent)
          .data()
          .toString()
          .contains(filterRegularExpression());
    };
    return contains(PlanTreeModel::name) || contains(PlanTreeModel::file);
  }
};

}  // namespace

PlanTree::PlanTree(ImportDraft& draft, QWidget* parent)
    : QTreeView(parent), m_model(new PlanTreeModel(draft, this)), m_filtered(new NameOrFile(this)) {
  setObjectName(QStringLiteral("planTree"));
  setAccessibleName(tr("What would be imported"));
  m_filtered->setSourceModel(m_model);
  m_filtered->setRecursiveFilteringEnabled(true);
  m_filtered->setAutoAcceptChildRows(true);
  m_filtered->setSortRole(PlanTreeModel::sortRole);
  m_filtered->setSortCaseSensitivity(Qt::CaseInsensitive);
  m_filtered->setSortLocaleAware(true);
  setModel(m_filtered);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(EditKeyPressed | SelectedClicked | DoubleClicked);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setSortingEnabled(true);
  header()->setSortIndicatorClearable(true);
  header()->setSectionsMovable(false);
  header()->setStretchLastSection(false);
  sortByColumn(-1, Qt::AscendingOrder);
  header()->setSectionResizeMode(PlanTreeModel::name, QHeaderView::Stretch);
  const int letter = fontMetrics().horizontalAdvance(QLatin1Char('x'));
  const int widths[] = {0, 12, 12, 26, 8, 7, 14, 15};
  for (int column = 1; column < PlanTreeModel::columns; ++column)
    setColumnWidth(column, widths[column] * letter);
  connect(m_model, &QAbstractItemModel::modelReset, this, &PlanTree::showAll);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &PlanTree::selectedNodesChanged);
}

void PlanTree::showAll() {
  expandAll();
}

void PlanTree::setFilter(const QString& text) {
  m_filtered->setFilterRegularExpression(QRegularExpression(
      QRegularExpression::escape(text), QRegularExpression::CaseInsensitiveOption));
  expandAll();
}

NodeIds PlanTree::selectedNodes() const {
  NodeIds ids;
  for (const QModelIndex& index : selectionModel()->selectedRows(PlanTreeModel::name))
    ids.push_back(m_model->idOf(m_filtered->mapToSource(index)));
  std::sort(ids.begin(), ids.end());
  return ids;
}

QModelIndex PlanTree::indexOf(model::NodeId id, int column) const {
  return m_filtered->mapFromSource(m_model->indexOf(id).siblingAtColumn(column));
}

void PlanTree::keyPressEvent(QKeyEvent* event) {
  const NodeIds ids = selectedNodes();
  if (event->key() != Qt::Key_Space || ids.empty() || state() == EditingState) {
    QTreeView::keyPressEvent(event);
    return;
  }
  const bool all = std::all_of(ids.begin(), ids.end(), [this](model::NodeId id) {
    return m_model->included(id) == Qt::Checked;
  });
  m_model->include(ids, !all);
}

}  // namespace sline::widgets

#include "moc_plan_tree.cpp"
