// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRect>
#include <optional>

#include "widgets/session/session.h"

class QPoint;
class QTreeView;

namespace sline::widgets {

class StructureTreeModel;

/// Where rows that are dragged come to stand if they are let go.
struct DropPlace {
  model::NodeId group;   ///< the root: the top level
  model::NodeId before;  ///< of its children; the root: behind the last
  /// In the view's viewport: a line between two rows, or, where they go into a group, its row.
  QRect mark;
  bool into = false;
};

/// Above the middle of a row: before it; below: behind it. The middle of a group's row, and all of
/// it but the upper part where the group is open, means into it; below all rows: the top level's
/// end. Nothing where the edit would refuse.
std::optional<DropPlace> dropPlace(const QTreeView& view, const StructureTreeModel& model,
                                   const model::Scene& scene, const NodeIds& ids, const QPoint& at);

}  // namespace sline::widgets
