// SPDX-License-Identifier: Apache-2.0
// Edits of the tree: Scene → Scene (see model/edit/style.h for `Edited`).
#pragma once

#include <string>

#include "model/edit/style.h"

namespace sline::model {

/// An empty or unchanged name changes nothing.
Edited renamed(const Scene& scene, NodeId id, const std::string& name);
/// Removes the nodes and everything below them, the sections that cut nothing else, the annotations
/// that point at them, and what saved views say of all these.
Edited removed(const Scene& scene, std::span<const NodeId> ids);
/// Moves the nodes (each with all below it) to the end of the group, in tree order. Moving a group
/// into itself, or into a structure, changes nothing.
Edited moved(const Scene& scene, std::span<const NodeId> ids, NodeId group);

}  // namespace sline::model
