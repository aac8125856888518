// SPDX-License-Identifier: Apache-2.0
// The scene's tree as Qt's views want it. Of each scene it works out the shape of the tree (ids,
// parents, order) and what the rows show, and asks the session for all else.
#pragma once

#include <QAbstractItemModel>
#include <unordered_map>
#include <vector>

#include "widgets/session/session.h"
#include "widgets/structure_tree/row_states.h"

namespace sline::widgets {

class StructureTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { eye, swatch, name, gamma, columns };
  enum Role {
    shownRole = Qt::UserRole,  ///< model::Shown as int
    coloursRole,               ///< QVariantList: up to three colours of the structures there
    lowGammaRole,              ///< float: smallest Γ of the structures there
    highGammaRole,             ///< float: largest
    ownGammaRole,              ///< bool: the node says Γ itself
  };

  explicit StructureTreeModel(Session& session, QObject* parent = nullptr);

  model::NodeId idOf(const QModelIndex& index) const;
  /// In the name's column; invalid for a node that is not in the tree.
  QModelIndex indexOf(model::NodeId id) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  struct Place {
    model::NodeId parent;
    int row = 0;
    std::vector<model::NodeId> children;
  };
  using Shape = std::unordered_map<std::uint64_t, Place>;
  static Shape shapeOf(const model::Scene& scene);
  const Place* place(model::NodeId id) const;
  const RowState& state(model::NodeId id) const;
  void change(const model::Scene& before, const model::Scene& now);
  QVariant describe(const QModelIndex& index) const;

  Session& m_session;
  Shape m_shape;
  RowStates m_states;  ///< worked out anew from each scene
};

}  // namespace sline::widgets
