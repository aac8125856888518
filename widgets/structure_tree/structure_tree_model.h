// SPDX-License-Identifier: Apache-2.0
// Presents the scene's tree, or what a filter leaves of it, to Qt's views. For each scene it
// computes the shape of the tree (ids, parents, order) and what the rows show, and asks the session
// for all else. It announces each row that changes, and each one that comes, goes or moves.
#pragma once

#include <QAbstractItemModel>

#include "widgets/session/other_sides.h"
#include "widgets/session/session.h"
#include "widgets/structure_tree/row_filter.h"
#include "widgets/structure_tree/row_states.h"
#include "widgets/structure_tree/tree_shape.h"

namespace sline::widgets {

class StructureTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { eye, swatch, name, gamma, lock, columns };
  enum Role {
    shownRole = Qt::UserRole,  ///< model::Visibility as int
    coloursRole,               ///< QVariantList: up to three colours of the structures there
    opacityRole,               ///< float: of the faintest
    lowGammaRole,              ///< float: smallest Γ of the structures there
    highGammaRole,             ///< float: largest
    ownGammaRole,              ///< bool: the node has a Γ of its own
    ownColourRole,             ///< bool: it has a colour or opacity of its own
    lockRole,                  ///< RowLock as int
  };

  explicit StructureTreeModel(Session& session, QObject* parent = nullptr);

  /// Sets the names under which structures are shown and found.
  void setNames(StructureNames names);
  /// Keeps only the rows that match (see RowFilter); an empty text keeps all.
  void setFilter(const QString& text);
  bool filtered() const { return m_filter.active(); }
  /// Returns the structures that match the filter; none where there is no filter.
  const NodeIds& matches() const { return m_matches; }

  model::NodeId idOf(const QModelIndex& index) const;
  /// Returns the index in the name's column; invalid for a node without a row.
  QModelIndex indexOf(model::NodeId id) const;
  const TreeShape& shape() const { return m_shape; }
  const RowState& state(model::NodeId id) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }

 signals:
  /// Encloses steps or a reset that add, remove or move rows. `opened`: another document.
  void rearranging();
  void rearranged(bool opened);

 private:
  TreeShape shapeOf(const model::Scene& scene);
  void change(const Document& before, const Document& now);
  void changeRows(const model::Scene& before, const model::Scene& now, const RowStates& old);
  void rearrange(TreeShape shape, bool opened);
  bool take(const RowStep& step);
  QString nameOf(const model::Node& node) const;
  QString describe(const QModelIndex& index) const;
  QString describeName(const model::Node& node) const;
  QString tipOf(const QModelIndex& index) const;
  QString describeGamma(const model::Node& node) const;
  QString describeColour(const model::Node& node) const;

  Session& m_session;
  RowFilter m_filter;
  NodeIds m_matches;
  TreeShape m_shape;
  RowStates m_states;               ///< computed anew for each scene
  mutable OtherSides m_otherSides;  ///< for who asks what a row says
};

}  // namespace sline::widgets
