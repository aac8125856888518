// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRect>
#include <optional>

#include "widgets/session/session.h"

class QPoint;
class QTreeView;

namespace sline::widgets {

class StructureTreeModel;

/// Tells where dragged rows go if they are dropped.
struct DropTarget {
  model::NodeId group;   ///< the root for the top level
  model::NodeId before;  ///< one of its children; the root for behind the last
  /// Its rectangle in the view's viewport: a line between two rows, or, where the rows go into a
  /// group, the group's row.
  QRect mark;
  bool into = false;
};

/// Returns the place for the mouse: above the middle of a row, before it; below, behind it. The
/// middle of a group's row, and all of it but the upper part where the group is open, means into
/// the group; below all rows means the end of the top level. Returns none where the edit would be
/// refused.
std::optional<DropTarget> dropTarget(const QTreeView& view, const StructureTreeModel& model,
                                     const model::Scene& scene, const NodeIds& ids,
                                     const QPoint& at);

}  // namespace sline::widgets
