// SPDX-License-Identifier: Apache-2.0
// What a lock means: a locked node, and all below a locked group, keeps its look, name and place
// and is not removed. Whether it is shown is no part of its look: what is locked can be hidden. The
// edits of style, emphasis and tree obey this; a new one does so with the functions here.
#pragma once

#include "model/edit/edited.h"
#include "model/edit/node_sets.h"

namespace sline::model {

/// Every node that is locked or stands below a locked group.
NodeSet lockedNodes(const Scene& scene);
/// Those of the ids that may be changed, in the order given; unknown ids are left out.
std::vector<NodeId> editable(const Scene& scene, std::span<const NodeId> ids);

/// The edit whose outcome is `after`, but for what it did to the looks of nodes that are locked:
/// their styles are as before, and what they would now inherit otherwise they say themselves. An
/// ink colour alone cannot be kept from those that had none.
Edited withLocksKept(const Scene& before, Scene after);

/// Locks the nodes, or unlocks them: what is locked by a group above stays so.
Edited withLocked(const Scene& scene, std::span<const NodeId> ids, bool locked);

}  // namespace sline::model
