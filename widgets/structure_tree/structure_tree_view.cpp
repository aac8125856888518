// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/structure_tree_view.h"

#include <QDragMoveEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "model/edit/locks.h"
#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/node_mime.h"
#include "widgets/structure_tree/structure_delegate.h"
#include "widgets/structure_tree/structure_edits.h"
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
      m_drag(session),
      m_sweep(session) {
  setObjectName(QStringLiteral("structureTree"));
  setAccessibleName(tr("Structures"));
  setModel(m_model);
  setItemDelegate(new StructureDelegate(this));
  setTreePosition(Model::name);
  setUniformRowHeights(true);
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
  if (!currentIndex().isValid() || !m_session.selection().empty() || m_model->filtered())
    setCurrentIndex(first);
}

bool StructureTreeView::pressControl(const QModelIndex& index, const QPointF& at) {
  switch (index.column()) {
    case Model::eye:
      m_sweep.begin(SwitchSweep::Switch::eye, idAt(index), meant(index));
      m_sweptTo = at.y();
      return true;
    case Model::lock:
      m_sweep.begin(SwitchSweep::Switch::lock, idAt(index), meant(index));
      m_sweptTo = at.y();
      return true;
    case Model::swatch:
      emit colourWanted(meant(index));
      return true;
    case Model::gamma:
      if (at.x() > GammaCell{QRectF(visualRect(index))}.number().left())
        return false;  // the number selects, like the name
      if (model::editable(m_session.scene(), meant(index)).empty()) {
        QToolTip::showText(viewport()->mapToGlobal(at.toPoint()), tr("Locked"), viewport());
        return true;
      }
      m_drag.begin(meant(index));
      m_dragged = idAt(index);
      dragGamma(at);
      return true;
    default:
      return false;
  }
}

bool StructureTreeView::resetControl(const QModelIndex& index) {
  if (index.column() == Model::gamma)
    inherit(m_session, meant(index), {.gamma = Gamma()});
  else if (index.column() == Model::swatch)
    inherit(m_session, meant(index), {.colour = Colour()});
  else
    return false;
  return true;
}

void StructureTreeView::dragGamma(const QPointF& at) {
  const GammaCell cell{QRectF(cellOf(m_dragged, Model::gamma))};
  m_drag.moveTo({.gamma = cell.gammaAt(at.x())});
}

void StructureTreeView::sweepTo(const QPointF& at) {
  // A fast mouse skips rows.
  const double step = std::max(1, rowHeight(m_model->index(0, 0)));
  const int column = m_sweep.what() == SwitchSweep::Switch::eye ? Model::eye : Model::lock;
  const int x = columnViewportPosition(column) + 1;
  const int rows = int(std::ceil(std::abs(at.y() - m_sweptTo) / step));
  for (int i = 1; i <= rows; ++i) {
    const double y = m_sweptTo + (at.y() - m_sweptTo) * i / rows;
    const QModelIndex row = indexAt(QPoint(x, int(y)));
    if (row.isValid())
      m_sweep.add(idAt(row));
  }
  m_sweptTo = at.y();
}

void StructureTreeView::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  m_adding = event->modifiers().testFlag(Qt::ControlModifier);
  if (index.isValid() && !m_drag.active() && !m_sweep.active()) {
    const bool left = event->button() == Qt::LeftButton;
    if (left && event->modifiers() == Qt::NoModifier && pressControl(index, event->position()))
      return;
    const bool alone =
        event->modifiers() == Qt::AltModifier || event->modifiers() == Qt::ControlModifier;
    if (left && alone && index.column() == Model::eye) {
      isolate(m_session, meant(index));
      return;
    }
    if (event->button() == Qt::MiddleButton && resetControl(index))
      return;
  }
  QTreeView::mousePressEvent(event);
}

void StructureTreeView::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag.active())
    dragGamma(event->position());
  else if (m_sweep.active())
    sweepTo(event->position());
  else
    QTreeView::mouseMoveEvent(event);
}

void StructureTreeView::mouseReleaseEvent(QMouseEvent* event) {
  if (m_drag.active() && event->button() == Qt::LeftButton)
    m_drag.finish(gammaText());
  else if (m_sweep.active() && event->button() == Qt::LeftButton)
    m_sweep.finish();
  else
    QTreeView::mouseReleaseEvent(event);
}

void StructureTreeView::mouseDoubleClickEvent(QMouseEvent* event) {
  // On a control the second click is one more click; on a name it renames.
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && index.column() != Model::name)
    mousePressEvent(event);
  else if (index.isValid() && event->button() == Qt::LeftButton &&
           visualRect(index).contains(event->position().toPoint()))
    rename(idAt(index));
  else
    QTreeView::mouseDoubleClickEvent(event);
}

void StructureTreeView::keyPressEvent(QKeyEvent* event) {
  m_adding = event->modifiers().testFlag(Qt::ControlModifier);
  const int key = event->key();
  if (key == Qt::Key_Escape && (m_drag.active() || m_sweep.active())) {
    m_drag.cancel();
    m_sweep.cancel();
  } else if (key == Qt::Key_Space && !m_adding) {
    toggleShown(m_session, m_session.selection());
  } else if (key == Qt::Key_Backspace) {
    inherit(m_session, m_session.selection(), {.gamma = Gamma()});
  } else if ((key == Qt::Key_Return || key == Qt::Key_Enter) &&
             event->modifiers().testFlags(Qt::NoModifier) && state() != EditingState) {
    emit zoomWanted();
  } else {
    QTreeView::keyPressEvent(event);
  }
}

void StructureTreeView::showDrop(std::optional<DropTarget> place) {
  m_drop = place;
  viewport()->update();
}

void StructureTreeView::dragMoveEvent(QDragMoveEvent* event) {
  QTreeView::dragMoveEvent(event);  // scrolls at the edges, opens groups
  const auto ids = nodesFromMime(m_session, *event->mimeData());
  showDrop(ids ? dropTarget(*this, *m_model, m_session.scene(), *ids, event->position().toPoint())
               : std::nullopt);
  if (m_drop) {
    event->setDropAction(Qt::MoveAction);
    event->accept();
  } else {
    event->ignore();
  }
}

void StructureTreeView::dragLeaveEvent(QDragLeaveEvent* event) {
  showDrop(std::nullopt);
  QTreeView::dragLeaveEvent(event);
}

void StructureTreeView::dropEvent(QDropEvent* event) {
  const auto ids = nodesFromMime(m_session, *event->mimeData());
  const auto place =
      ids ? dropTarget(*this, *m_model, m_session.scene(), *ids, event->position().toPoint())
          : std::nullopt;
  showDrop(std::nullopt);
  setState(NoState);
  stopAutoScroll();
  if (!place) {
    event->ignore();
    return;
  }
  event->setDropAction(Qt::MoveAction);
  event->accept();
  moveNodes(m_session, *ids, place->group, place->before);
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
