// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/plan_tree.h"

#include <QHash>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <vector>

#include "widgets/session/typed_wishes.h"

namespace sline::widgets {

/// Filters by names and files, those of groups holding for what is in them; the other columns are
/// only sorted.
class NameOrFile : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setWishes(const QString& text) {
    if (m_wishes.setText(text))
      invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    std::vector<bool> found(m_wishes.words().size());
    for (QModelIndex index = sourceModel()->index(row, 0, parent);
         m_wishes.active() && index.isValid(); index = index.parent()) {
      const SearchedNames& names = namesOf(index);
      for (std::size_t i = 0; i < found.size(); ++i)
        found[i] = found[i] || names.have(m_wishes.words()[i]);
    }
    return m_wishes.satisfied(found);
  }

 private:
  const SearchedNames& namesOf(const QModelIndex& index) const {
    QStringList called;
    for (const int column : {PlanTreeModel::name, PlanTreeModel::file})
      called << index.siblingAtColumn(column).data().toString();
    const QString key = called.join(u'\n');
    const auto known = m_known.constFind(key);
    if (known != m_known.cend())
      return *known;
    SearchedNames names{.text = searchable(key), .words = {}, .sides = {}};
    for (const QString& name : called)
      names.addWords(name);
    return *m_known.insert(key, std::move(names));
  }

  TypedWishes m_wishes;
  mutable QHash<QString, SearchedNames> m_known;  ///< by name and file
};

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
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!m_filtering)
      emit selectedNodesChanged();
  });
}

void PlanTree::showAll() {
  expandAll();
}

void PlanTree::setFilter(const QString& text) {
  // Rows come and go one range after another, each of which a selection looks at; so it is put down
  // for so long, and taken up again once.
  const NodeIds before = selectedNodes();
  m_filtering = true;
  selectionModel()->clearSelection();
  m_filtered->setWishes(text);
  expandAll();
  selectNodes(before);
  m_filtering = false;
  if (selectedNodes() != before)
    emit selectedNodesChanged();
}

void PlanTree::selectNodes(const NodeIds& ids) {
  QItemSelection selection;
  const auto wanted = [&](const QModelIndex& index) {
    return std::binary_search(ids.begin(), ids.end(),
                              m_model->idOf(m_filtered->mapToSource(index)));
  };
  std::vector<QModelIndex> parents{QModelIndex()};
  while (!parents.empty()) {
    const QModelIndex parent = parents.back();
    parents.pop_back();
    const int rows = m_filtered->rowCount(parent);
    int first = 0;  // of the rows in turn that are wanted
    for (int row = 0; row < rows; ++row) {
      const QModelIndex index = m_filtered->index(row, 0, parent);
      if (m_filtered->hasChildren(index))
        parents.push_back(index);
      if (!wanted(index))
        first = row + 1;
      else if (row + 1 == rows || !wanted(index.siblingAtRow(row + 1)))
        selection.append({m_filtered->index(first, 0, parent),
                          index.siblingAtColumn(PlanTreeModel::columns - 1)});
    }
  }
  selectionModel()->select(selection, QItemSelectionModel::Select);
}

NodeIds PlanTree::selectedNodes() const {
  NodeIds ids;
  // The ranges are of whole rows. QItemSelectionModel::selectedRows would look for each row in all
  // of them.
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row)
      ids.push_back(m_model->idOf(
          m_filtered->mapToSource(m_filtered->index(row, PlanTreeModel::name, range.parent()))));
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
