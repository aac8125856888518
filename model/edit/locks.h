// SPDX-License-Identifier: Apache-2.0
// Implements locks: a locked node, and everything below a locked group, keeps its look, name and
// place and is not removed. Visibility is not part of a look, so locked nodes can be hidden. The
// edits of style, emphasis and tree obey this; a new edit does so with the functions here.
#pragma once

#include "model/edit/edited.h"
#include "model/edit/node_sets.h"

namespace sline::model {

/// Returns every node that is locked or stands below a locked group.
NodeSet lockedNodes(const Scene& scene);
/// Returns those of the ids that may be changed, in the order given; unknown ids are left out.
std::vector<NodeId> editable(const Scene& scene, std::span<const NodeId> ids);

/// Returns the edit whose outcome is `after`, except that it leaves the looks of locked nodes
/// alone: their styles are as before, and they answer themselves the fields that they would now
/// inherit differently. Only an ink colour cannot be kept from nodes that had none.
Edited withLocksKept(const Scene& before, Scene after);

/// Locks the nodes, or unlocks them; nodes locked by a group above stay locked.
Edited withLocked(const Scene& scene, std::span<const NodeId> ids, bool locked);

}  // namespace sline::model
