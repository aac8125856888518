// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree_view.h"

#include <QHeaderView>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <algorithm>

#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/structure_delegate.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

using Model = StructureTreeModel;

namespace {
/// The number of rows above which a document that is opened shows its top level alone.
constexpr std::size_t rowsAtAGlance = 300;
}  // namespace

StructureTreeView::StructureTreeView(Session& session, QWidget* parent)
    : QTreeView(parent),
      m_session(session),
      m_model(new Model(session, this)),
      m_drag(session, gammaNumber()),
      m_sweep(session) {
  setObjectName(QStringLiteral("structureTree"));
  setAccessibleName(tr("Structures"));
  setModel(m_model);
  auto* delegate = new StructureDelegate(this);
  setItemDelegate(delegate);
  connect(m_model, &Model::rearranged, delegate, &StructureDelegate::forgetNames);
  connect(m_model, &Model::dataChanged, delegate,
          [delegate](const QModelIndex& first, const QModelIndex& last) {
            if (first.column() <= Model::name && last.column() >= Model::name)
              delegate->forgetNames();
          });
  setTreePosition(Model::name);
  setUniformRowHeights(true);
  // What tells long names apart, a side or a number, stands at their end.
  setTextElideMode(Qt::ElideMiddle);
  setSelectionMode(ExtendedSelection);
  setSelectionBehavior(SelectRows);
  setEditTriggers(NoEditTriggers);
  setExpandsOnDoubleClick(false);
  setAllColumnsShowFocus(true);
  setIndentation(14);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  setFrameShape(NoFrame);
  setDragEnabled(true);
  setAcceptDrops(true);
  setDropIndicatorShown(false);  // the line and the frame are painted here
  setDragDropMode(DragDrop);
  setDefaultDropAction(Qt::MoveAction);
  setAutoExpandDelay(700);
  setAutoScrollMargin(24);
  shapeColumns();
  connectModel();
  afterArranging(true);
}

void StructureTreeView::shapeColumns() {
  QHeaderView* columns = header();
  columns->setStretchLastSection(false);
  columns->setSectionsMovable(false);
  columns->setMinimumSectionSize(24);
  for (const auto& [column, width] :
       {std::pair(Model::eye, 30), {Model::swatch, 26}, {Model::gamma, 132}, {Model::lock, 26}}) {
    columns->setSectionResizeMode(column, QHeaderView::Fixed);
    columns->resizeSection(column, width);
  }
  columns->setSectionResizeMode(Model::name, QHeaderView::Stretch);
  // Names need some room to be of use.
  constexpr int letters = 16;
  setMinimumWidth(columns->length() - columns->sectionSize(Model::name) +
                  letters * fontMetrics().averageCharWidth() + indentation());
}

void StructureTreeView::connectModel() {
  connect(m_model, &Model::rearranging, this, &StructureTreeView::beforeArranging);
  connect(m_model, &Model::rearranged, this, &StructureTreeView::afterArranging);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &StructureTreeView::toSession);
  connect(&m_session, &Session::selectionChanged, this, [this] {
    fromSession();
    if (!m_following && !m_session.selection().empty()) {
      const QModelIndex row = indexOf(m_session.selection().front());
      if (row.isValid())
        scrollTo(row);
    }
  });
  connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
    if (!m_arranging && !m_model->filtered())
      m_closed.insert(idAt(index).value);
  });
  connect(this, &QTreeView::expanded, this, [this](const QModelIndex& index) {
    if (!m_arranging && !m_model->filtered())
      m_closed.erase(idAt(index).value);
  });
}

void StructureTreeView::setNames(StructureNames names) {
  m_model->setNames(std::move(names));
}

void StructureTreeView::setFilter(const QString& text) {
  m_model->setFilter(text);
  emit filtered();
}

const NodeIds& StructureTreeView::matches() const {
  return m_model->matches();
}

void StructureTreeView::beforeArranging() {
  m_following = true;
  m_arranging = true;
  m_scroll = verticalScrollBar()->value();
  m_current = currentIndex().isValid() ? idAt(currentIndex()) : model::rootId;
}

void StructureTreeView::afterArranging(bool opened) {
  if (opened) {
    m_closed.clear();
    if (m_model->shape().rows() > rowsAtAGlance)
      for (const model::Node& node : m_session.scene().nodes())
        if (node.isGroup())
          m_closed.insert(node.id.value);
  }
  openGroups();
  m_arranging = false;
  m_following = false;
  fromSession();
  if (opened)
    return;
  if (!currentIndex().isValid() && indexOf(m_current).isValid())
    selectionModel()->setCurrentIndex(indexOf(m_current), QItemSelectionModel::NoUpdate);
  executeDelayedItemsLayout();
  verticalScrollBar()->setValue(m_scroll);
}

void StructureTreeView::openGroups() {
  const QScopedValueRollback arranging(m_arranging, true);
  for (const model::Node& node : m_session.scene().nodes()) {
    const QModelIndex row = node.isGroup() ? indexOf(node.id).siblingAtColumn(0) : QModelIndex();
    const bool open = m_model->filtered() || !m_closed.contains(node.id.value);
    if (row.isValid() && isExpanded(row) != open)
      setExpanded(row, open);
  }
}

model::NodeId StructureTreeView::idAt(const QModelIndex& shown) const {
  return m_model->idOf(shown);
}

QModelIndex StructureTreeView::indexOf(model::NodeId id) const {
  return m_model->indexOf(id);
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

void StructureTreeView::rename(model::NodeId id) {
  const QModelIndex index = indexOf(id);
  if (!index.isValid())
    return;
  setFocus();
  m_adding = false;
  scrollTo(index);
  // The row is selected here and not by the view, which would toggle it while Ctrl is down, as with
  // Ctrl+G.
  selectionModel()->setCurrentIndex(
      index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  edit(index);
}

void StructureTreeView::renameCurrent() {
  const NodeIds& selected = m_session.selection();
  const model::NodeId current = idAt(currentIndex());
  const bool part = std::find(selected.begin(), selected.end(), current) != selected.end();
  if (part || !selected.empty())
    rename(part ? current : selected.front());
}

void StructureTreeView::enter() {
  setFocus();
  const NodeIds& matches = m_model->matches();
  const QModelIndex first =
      matches.empty() ? m_model->index(0, Model::name) : indexOf(matches.front());
  // Ctrl that was down when the keys left the tree adds nothing now.
  m_adding = false;
  if (!currentIndex().isValid() || !m_session.selection().empty() || m_model->filtered())
    selectionModel()->setCurrentIndex(
        first, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void StructureTreeView::paintEvent(QPaintEvent* event) {
  QTreeView::paintEvent(event);
  if (!m_drop || m_drop->mark.isNull())
    return;
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  paintDropMark(painter, m_drop->mark, m_drop->into, palette());
}

void StructureTreeView::toSession() {
  if (m_following)
    return;
  NodeIds ids;
  for (const QModelIndex& index : selectionModel()->selectedRows(Model::name))
    ids.push_back(idAt(index));
  if (m_adding)
    for (const model::NodeId id : m_session.selection())
      if (!indexOf(id).isValid())
        ids.push_back(id);
  const QScopedValueRollback following(m_following, true);
  m_session.select(std::move(ids));
}

void StructureTreeView::fromSession() {
  if (m_following)
    return;
  const QScopedValueRollback following(m_following, true);
  // Neighbours are selected as one range, because Qt compares each range with all others.
  std::vector<QModelIndex> rows;
  for (const model::NodeId id : m_session.selection())
    if (const QModelIndex index = indexOf(id); index.isValid())
      rows.push_back(index);
  const auto before = [](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a.parent().internalId(), a.row()) <
           std::pair(b.parent().internalId(), b.row());
  };
  std::sort(rows.begin(), rows.end(), before);
  QItemSelection selection;
  for (std::size_t first = 0, last = 0; first < rows.size(); first = ++last) {
    while (last + 1 < rows.size() && rows[last + 1].parent() == rows[first].parent() &&
           rows[last + 1].row() == rows[last].row() + 1)
      ++last;
    selection.append(QItemSelectionRange(rows[first].siblingAtColumn(0),
                                         rows[last].siblingAtColumn(Model::columns - 1)));
  }
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  const bool elsewhere = !rows.empty() && !selectionModel()->isSelected(currentIndex());
  if (elsewhere)
    selectionModel()->setCurrentIndex(rows.front(), QItemSelectionModel::NoUpdate);
}

}  // namespace sline::widgets

#include "moc_structure_tree_view.cpp"
