// SPDX-License-Identifier: Apache-2.0
// The tree on screen: clicks on eyes and swatches, drags of Γ, keys.
#pragma once

#include <QTreeView>

#include "widgets/gamma/gamma_drag.h"

class QSortFilterProxyModel;

namespace sline::widgets {

class StructureTreeModel;

class StructureTreeView : public QTreeView {
  Q_OBJECT
 public:
  explicit StructureTreeView(Session& session, QWidget* parent = nullptr);

  /// Shows the structures whose names, or whose groups' names, contain the text.
  void setFilter(const QString& text);
  /// The row, by its name's cell; invalid where the filter hides it.
  QModelIndex indexOf(model::NodeId id) const;
  /// The row's cell in the viewport; empty where the row is out of sight.
  QRect cellOf(model::NodeId id, int column) const;
  /// Hides what is selected where all of it is shown, else shows it.
  void toggleSelection();

 signals:
  void colourWanted(const std::vector<sline::model::NodeId>& ids);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  model::NodeId idAt(const QModelIndex& shown) const;
  /// The selection where the row is part of it, else the row alone.
  NodeIds meant(const QModelIndex& shown) const;
  void toggle(const NodeIds& ids);
  bool pressControl(const QModelIndex& index, const QPointF& at);
  void dragGamma(const QPointF& at);
  void toSession();
  void fromSession();

  Session& m_session;
  StructureTreeModel* m_model;
  QSortFilterProxyModel* m_filtered;
  GammaDrag m_drag;
  model::NodeId m_dragged;
  bool m_following = false;  ///< the session's selection, not the person's
};

}  // namespace sline::widgets
