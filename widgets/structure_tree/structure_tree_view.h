// SPDX-License-Identifier: Apache-2.0
// Shows the tree on screen: clicks on eyes, swatches and locks, drags of Γ and of rows, keys.
#pragma once

#include <QPersistentModelIndex>
#include <QTreeView>
#include <optional>

#include "model/edit/node_sets.h"
#include "widgets/gamma/look_drag.h"
#include "widgets/structure_tree/drop_target.h"
#include "widgets/structure_tree/structure_names.h"
#include "widgets/structure_tree/switch_sweep.h"

namespace sline::widgets {

class StructureTreeModel;

class StructureTreeView : public QTreeView {
  Q_OBJECT
 public:
  explicit StructureTreeView(Session& session, QWidget* parent = nullptr);

  /// Sets the names under which structures are shown and found.
  void setNames(StructureNames names);
  /// Shows the structures that have all words of the text in their names or their groups' names.
  void setFilter(const QString& text);
  /// Returns the structures that match the filter; none where there is no filter.
  const NodeIds& matches() const;
  /// Returns the index of the row's name cell; invalid where the filter hides it.
  QModelIndex indexOf(model::NodeId id) const;
  /// Returns the row's cell in the viewport; empty where the row is out of sight.
  QRect cellOf(model::NodeId id, int column) const;
  /// Opens the editor of the node's name, or of the current row's.
  void rename(model::NodeId id);
  void renameCurrent();
  /// Makes the first row the current one if there is none.
  void enter();

 signals:
  void colourWanted(const std::vector<sline::model::NodeId>& ids);
  /// Tells that Enter was pressed, which brings the selection into the picture.
  void zoomWanted();
  void filtered();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void shapeColumns();
  void connectModel();
  model::NodeId idAt(const QModelIndex& shown) const;
  /// Returns the selection if the row is part of it, else the row alone.
  NodeIds meant(const QModelIndex& shown) const;
  /// Begins what the cell is for; `levels`: a drag makes the values of several structures equal.
  bool pressControl(const QModelIndex& index, const QPointF& at, bool levels);
  /// Makes the cell's value inherit from the group above again.
  bool resetControl(const QModelIndex& index);
  void dragGamma(const QPointF& at);
  void sweepTo(const QPointF& at);
  void showDrop(std::optional<DropTarget> place);
  void toSession();
  void fromSession();
  /// Remembers the state before the rows are rearranged, so that open groups are open again
  /// afterwards.
  void beforeArranging();
  void afterArranging(bool opened);
  void openGroups();

  Session& m_session;
  StructureTreeModel* m_model;
  LookDrag m_drag;
  model::NodeId m_dragged;
  SwitchSweep m_sweep;
  double m_sweptTo = 0.0;
  std::optional<DropTarget> m_drop;
  model::NodeSet m_closed;   ///< groups that the user closed
  bool m_arranging = false;  ///< groups open and close by themselves
  bool m_following = false;  ///< the session's selection is followed, not the user's
  bool m_adding = false;     ///< Ctrl is down: what the filter hides stays selected
  int m_scroll = 0;          ///< where the rows stood before they are rearranged
  model::NodeId m_current;   ///< the current row, likewise
};

}  // namespace sline::widgets
