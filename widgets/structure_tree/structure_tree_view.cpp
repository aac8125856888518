// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree_view.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <algorithm>

#include "model/edit/visibility.h"
#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/structure_delegate.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

using Model = StructureTreeModel;

StructureTreeView::StructureTreeView(Session& session, QWidget* parent)
    : QTreeView(parent),
      m_session(session),
      m_model(new Model(session, this)),
      m_filtered(new QSortFilterProxyModel(this)),
      m_drag(session) {
  setObjectName(QStringLiteral("structureTree"));
  setAccessibleName(tr("Structures"));
  m_filtered->setSourceModel(m_model);
  m_filtered->setFilterKeyColumn(Model::name);
  m_filtered->setFilterCaseSensitivity(Qt::CaseInsensitive);
  m_filtered->setRecursiveFilteringEnabled(true);
  m_filtered->setAutoAcceptChildRows(true);
  setModel(m_filtered);
  setItemDelegate(new StructureDelegate(this));
  setTreePosition(Model::name);
  setUniformRowHeights(true);
  setSelectionMode(ExtendedSelection);
  setSelectionBehavior(SelectRows);
  setEditTriggers(EditKeyPressed);
  setAllColumnsShowFocus(true);
  setIndentation(14);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  setFrameShape(NoFrame);

  QHeaderView* columns = header();
  columns->setStretchLastSection(false);
  columns->setSectionsMovable(false);
  columns->setMinimumSectionSize(24);
  columns->setSectionResizeMode(Model::eye, QHeaderView::Fixed);
  columns->setSectionResizeMode(Model::swatch, QHeaderView::Fixed);
  columns->setSectionResizeMode(Model::name, QHeaderView::Stretch);
  columns->setSectionResizeMode(Model::gamma, QHeaderView::Fixed);
  columns->resizeSection(Model::eye, 30);
  columns->resizeSection(Model::swatch, 26);
  columns->resizeSection(Model::gamma, 132);

  connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
    expandAll();
    fromSession();
  });
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &StructureTreeView::toSession);
  connect(&session, &Session::selectionChanged, this, &StructureTreeView::fromSession);
  expandAll();
}

void StructureTreeView::setFilter(const QString& text) {
  {
    // What the filter hides stays selected: looking for one structure forgets no other.
    const QScopedValueRollback following(m_following, true);
    m_filtered->setFilterFixedString(text.trimmed());
  }
  expandAll();
  fromSession();
}

model::NodeId StructureTreeView::idAt(const QModelIndex& shown) const {
  return m_model->idOf(m_filtered->mapToSource(shown));
}

QModelIndex StructureTreeView::indexOf(model::NodeId id) const {
  return m_filtered->mapFromSource(m_model->indexOf(id));
}

QRect StructureTreeView::cellOf(model::NodeId id, int column) const {
  const QModelIndex index = indexOf(id);
  return index.isValid() ? visualRect(index.siblingAtColumn(column)) : QRect();
}

NodeIds StructureTreeView::meant(const QModelIndex& shown) const {
  const model::NodeId id = idAt(shown);
  const NodeIds& selected = m_session.selection();
  const bool part = std::find(selected.begin(), selected.end(), id) != selected.end();
  return part ? selected : NodeIds{id};
}

void StructureTreeView::toggle(const NodeIds& ids) {
  const model::Scene& scene = m_session.scene();
  const bool all = std::all_of(ids.begin(), ids.end(), [&](model::NodeId id) {
    return model::shownOf(scene, id) == model::Shown::all;
  });
  if (all)
    m_session.apply(tr("Hide"), model::withHidden(scene, ids));
  else
    m_session.apply(tr("Show"), model::withShown(scene, ids));
}

void StructureTreeView::toggleSelection() {
  if (!m_session.selection().empty())
    toggle(m_session.selection());
}

bool StructureTreeView::pressControl(const QModelIndex& index, const QPointF& at) {
  switch (index.column()) {
    case Model::eye:
      toggle(meant(index));
      return true;
    case Model::swatch:
      emit colourWanted(meant(index));
      return true;
    case Model::gamma:
      if (at.x() > GammaCell{QRectF(visualRect(index))}.number().left())
        return false;  // the number selects, like the name
      m_drag.begin(meant(index));
      m_dragged = idAt(index);
      dragGamma(at);
      return true;
    default:
      return false;
  }
}

void StructureTreeView::dragGamma(const QPointF& at) {
  const GammaCell cell{QRectF(cellOf(m_dragged, Model::gamma))};
  m_drag.moveTo(cell.gammaAt(at.x()));
}

void StructureTreeView::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  if (plain && index.isValid() && pressControl(index, event->position()))
    return;
  QTreeView::mousePressEvent(event);
}

void StructureTreeView::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag.active())
    dragGamma(event->position());
  else
    QTreeView::mouseMoveEvent(event);
}

void StructureTreeView::mouseReleaseEvent(QMouseEvent* event) {
  if (m_drag.active() && event->button() == Qt::LeftButton)
    m_drag.finish();
  else
    QTreeView::mouseReleaseEvent(event);
}

void StructureTreeView::mouseDoubleClickEvent(QMouseEvent* event) {
  // On a control the second click is one more click.
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && index.column() != Model::name)
    mousePressEvent(event);
  else
    QTreeView::mouseDoubleClickEvent(event);
}

void StructureTreeView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_drag.active())
    m_drag.cancel();
  else if (event->key() == Qt::Key_Space)
    toggleSelection();
  else
    QTreeView::keyPressEvent(event);
}

void StructureTreeView::toSession() {
  if (m_following)
    return;
  NodeIds ids;
  for (const QModelIndex& index : selectionModel()->selectedRows(Model::name))
    ids.push_back(idAt(index));
  const QScopedValueRollback following(m_following, true);
  m_session.select(std::move(ids));
}

void StructureTreeView::fromSession() {
  if (m_following)
    return;
  const QScopedValueRollback following(m_following, true);
  QItemSelection selection;
  for (const model::NodeId id : m_session.selection()) {
    const QModelIndex index = indexOf(id);
    if (index.isValid())
      selection.select(index.siblingAtColumn(0), index.siblingAtColumn(Model::gamma));
  }
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  if (!selection.isEmpty())
    scrollTo(indexOf(m_session.selection().front()));
}

}  // namespace sline::widgets
