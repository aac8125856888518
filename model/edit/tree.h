// SPDX-License-Identifier: Apache-2.0
// Edits of the tree: Scene → Scene. What is locked keeps its
// name and its place and is not removed (model/edit/locks.h).
#pragma once

#include <string>

#include "model/edit/edited.h"

namespace sline::model {

/// An empty or unchanged name changes nothing.
Edited renamed(const Scene& scene, NodeId id, const std::string& name);
/// Removes the nodes and everything below them, the sections that cut nothing else, the annotations
/// that point at them, and what saved views say of all these. What is locked stays, and so do the
/// groups above it.
Edited removed(const Scene& scene, std::span<const NodeId> ids);
/// Moves the nodes (each with all below it) into the group, in tree order: before that child of the
/// group, or to the end where `before` is none of its children. Moving a group into itself, or
/// anything into a structure or a locked group, changes nothing.
Edited moved(const Scene& scene, std::span<const NodeId> ids, NodeId group, NodeId before = rootId);

struct Grouped {
  Edited edited;
  NodeId group;  ///< the new one; the root where there is none
};
/// A new, empty group at the end of the group `parent`.
Grouped withGroup(const Scene& scene, const std::string& name, NodeId parent = rootId);
/// The nodes in a new group, which stands where the first of them stood.
Grouped grouped(const Scene& scene, std::span<const NodeId> ids, const std::string& name);
/// Dissolves the groups among the nodes: what was in one takes its place and says itself what it
/// inherited from it, so that it looks as before. Sections of the group alone go with it. A group
/// that is locked, or holds something locked, stays.
Edited ungrouped(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
