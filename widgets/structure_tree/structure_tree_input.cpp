// SPDX-License-Identifier: Apache-2.0
// Handles input in the tree: mouse, keys and what is dropped.
#include <QDragMoveEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "model/edit/locks.h"
#include "widgets/structure_tree/cell_painting.h"
#include "widgets/structure_tree/node_mime.h"
#include "widgets/structure_tree/structure_edits.h"
#include "widgets/structure_tree/structure_tree_model.h"
#include "widgets/structure_tree/structure_tree_view.h"

namespace sline::widgets {

using Model = StructureTreeModel;

namespace {

/// Returns the Γ at which the row's handle stands.
float middleGamma(const QModelIndex& index) {
  return 0.5f *
         (index.data(Model::lowGammaRole).toFloat() + index.data(Model::highGammaRole).toFloat());
}

}  // namespace

bool StructureTreeView::pressControl(const QModelIndex& index, const QPointF& at, bool levels) {
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
      m_dragged = idAt(index);
      m_drag.begin({meant(index), middleGamma(index), levels});
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
  m_drag.moveTo(cell.gammaAt(at.x()).value());
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
    const bool levels = event->modifiers() == Qt::ShiftModifier && index.column() == Model::gamma;
    if (left && (levels || event->modifiers() == Qt::NoModifier) &&
        pressControl(index, event->position(), levels))
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

}  // namespace sline::widgets
