// SPDX-License-Identifier: Apache-2.0
// Presents the tree of an import plan to Qt's views.
#pragma once

#include <QAbstractItemModel>
#include <unordered_map>
#include <vector>

#include "widgets/import_dialog/import_draft.h"

namespace sline::widgets {

class PlanTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { name, triangles, size, file, frame, unit, smoothing, decimation, columns };
  enum Role { sortRole = Qt::UserRole };

  explicit PlanTreeModel(ImportDraft& draft, QObject* parent = nullptr);

  model::NodeId idOf(const QModelIndex& index) const;
  QModelIndex indexOf(model::NodeId id) const;
  /// Returns the structures at or below the nodes, each once.
  NodeIds structuresOf(const NodeIds& ids) const;
  /// Imports or leaves out all structures at or below the nodes.
  void include(const NodeIds& ids, bool wanted);
  Qt::CheckState included(model::NodeId id) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  struct Entry {
    model::NodeId parent;
    int row = 0;
    std::size_t node = 0;  ///< in Scene::nodes
    std::vector<model::NodeId> children = {};
    bool operator==(const Entry&) const = default;
  };
  const model::Node* nodeOf(model::NodeId id) const;
  void reset();
  void countChecks();
  void showChosen();
  QString text(const model::Node& node, int column) const;
  QVariant sortKey(const model::Node& node, int column) const;
  QVariant decoration(const model::Node& node) const;

  ImportDraft& m_draft;
  std::unordered_map<std::uint64_t, Entry> m_places;
  std::unordered_map<std::uint64_t, Qt::CheckState> m_checks;  ///< computed after each choice
};

}  // namespace sline::widgets
