// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/drop_target.h"

#include <QTreeView>
#include <algorithm>

#include "model/edit/locks.h"
#include "widgets/structure_tree/structure_tree_model.h"

namespace sline::widgets {

namespace {

using Model = StructureTreeModel;

/// Returns the sibling that stands behind it in the group; the root where it is the last.
model::NodeId behind(const Model& model, model::NodeId id) {
  const TreeShape::Entry& place = *model.shape().find(id);
  const NodeIds& siblings = model.shape().find(place.parent)->children;
  const auto next = std::size_t(place.row) + 1;
  return next < siblings.size() ? siblings[next] : model::rootId;
}

DropTarget between(const QTreeView& view, const QModelIndex& row, int y) {
  const QRect name = view.visualRect(row.siblingAtColumn(Model::name));
  return {.mark = QRect(QPoint(name.left(), y), QPoint(view.viewport()->width() - 1, y))};
}

DropTarget placeAt(const QTreeView& view, const Model& model, const QPoint& at) {
  const QModelIndex row = view.indexAt(at);
  if (!row.isValid()) {
    const int rows = model.rowCount();
    DropTarget end;
    if (rows > 0) {
      QModelIndex last = model.index(rows - 1, Model::name);
      while (view.isExpanded(last.siblingAtColumn(0)) &&
             model.rowCount(last.siblingAtColumn(0)) > 0)
        last = model.index(model.rowCount(last.siblingAtColumn(0)) - 1, Model::name,
                           last.siblingAtColumn(0));
      const int y = view.visualRect(last).bottom();
      end.mark = QRect(QPoint(0, y), QPoint(view.viewport()->width() - 1, y));
    }
    return end;
  }
  const model::NodeId id = model.idOf(row);
  const QModelIndex first = row.siblingAtColumn(0);
  const QRect cell = view.visualRect(row);
  const double part = double(at.y() - cell.top()) / cell.height();
  const bool group = model.state(id).group;
  const bool open = view.isExpanded(first) && model.rowCount(first) > 0;
  if (group && part > 0.25 && (open || part < 0.75))
    return {.group = id,
            .mark = QRect(0, cell.top(), view.viewport()->width(), cell.height()),
            .into = true};
  const bool above = part < 0.5;
  DropTarget place = between(view, row, above ? cell.top() : cell.bottom());
  place.group = model.shape().find(id)->parent;
  place.before = above ? id : behind(model, id);
  return place;
}

}  // namespace

std::optional<DropTarget> dropTarget(const QTreeView& view, const StructureTreeModel& model,
                                     const model::Scene& scene, const NodeIds& ids,
                                     const QPoint& at) {
  const DropTarget place = placeAt(view, model, at);
  const NodeIds moving = model::editable(scene, ids);
  const bool intoItself = std::any_of(moving.begin(), moving.end(), [&](model::NodeId id) {
    return scene.isBelow(place.group, id);
  });
  if (moving.empty() || intoItself || (place.group != model::rootId && scene.isLocked(place.group)))
    return std::nullopt;
  return place;
}

}  // namespace sline::widgets
