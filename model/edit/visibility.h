// SPDX-License-Identifier: Apache-2.0
// Showing and hiding: edits Scene → Scene.
#pragma once

#include <span>

#include "model/edit/edited.h"

namespace sline::model {

/// What of a structure, or of the structures in a group, is shown.
enum class Shown { none, some, all };
Shown shownOf(const Scene& scene, NodeId id);

/// Hides the nodes; what stands below them remembers its own state.
Edited withHidden(const Scene& scene, std::span<const NodeId> ids);
/// Shows the nodes. A hidden group comes back as it was before it was hidden; one that shows a
/// part, or would show nothing, shows all. Where a group above is hidden, it is shown with nothing
/// else in it.
Edited withShown(const Scene& scene, std::span<const NodeId> ids);
/// Hides what is not at or below the nodes and not above them. The nodes stay as they are, unlike
/// with `withOnlyVisible`, which shows them.
Edited withOthersHidden(const Scene& scene, std::span<const NodeId> ids);
/// Shows exactly the structures at or below the nodes: everything else is hidden, groups above the
/// shown ones are made visible.
Edited withOnlyVisible(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
