// SPDX-License-Identifier: Apache-2.0
// Edits the tree: Scene → Scene. A locked node keeps its name and its place and is not removed
// (model/edit/locks.h).
#pragma once

#include <functional>
#include <map>
#include <string>

#include "model/edit/edited.h"

namespace sline::model {

/// Returns what a structure of that name is called in other languages, by BCP 47 tag; empty where
/// nobody knows.
using NamesOf = std::function<std::map<std::string, std::string>(const std::string& name)>;

/// Renames the node; an empty or unchanged name changes nothing. Labels on it that are called as it
/// was follow, in every language by itself; texts that were edited stay.
Edited renamed(const Scene& scene, NodeId id, const std::string& name, const NamesOf& namesOf = {});
/// Removes the nodes and everything below them, the sections that cut nothing else, the annotations
/// that point at them, and their entries in saved views. Locked nodes stay, and so do the groups
/// above them.
Edited removed(const Scene& scene, std::span<const NodeId> ids);
/// Moves the nodes (each with all below it) into the group, in tree order: before that child of the
/// group, or to the end where `before` is none of its children. Moving a group into itself, or
/// anything into a structure or a locked group, changes nothing.
Edited moved(const Scene& scene, std::span<const NodeId> ids, NodeId group, NodeId before = rootId);

struct Grouped {
  Edited edited;
  NodeId group;  ///< the new group; the root where none was made
};
/// Adds a new, empty group at the end of the group `parent`.
Grouped withGroup(const Scene& scene, const std::string& name, NodeId parent = rootId);
/// Puts the nodes into a new group, which stands where the first of them stood.
Grouped grouped(const Scene& scene, std::span<const NodeId> ids, const std::string& name);
/// Dissolves the groups among the nodes: their children take the group's place and answer
/// themselves what they inherited from it, so that they look as before. Sections of the group alone
/// go with it. A group that is locked, or holds a locked node, stays.
Edited ungrouped(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
