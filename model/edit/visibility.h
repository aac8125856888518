// SPDX-License-Identifier: Apache-2.0
// Shows and hides nodes: Scene → Scene.
#pragma once

#include <span>

#include "model/edit/edited.h"

namespace sline::model {

/// Says how much of a structure, or of the structures in a group, is shown.
enum class Visibility { none, some, all };
Visibility visibilityOf(const Scene& scene, NodeId id);

/// Hides the nodes; the nodes below them remember their own state.
Edited withHidden(const Scene& scene, std::span<const NodeId> ids);
/// Shows the nodes. A hidden group comes back as it was before it was hidden; a group that shows
/// only a part, or would show nothing, shows everything. A hidden group above is shown with nothing
/// else in it.
Edited withShown(const Scene& scene, std::span<const NodeId> ids);
/// Hides everything that is neither at or below the nodes nor above them. The nodes stay as they
/// are, unlike with `withOnlyVisible`, which shows them.
Edited withOthersHidden(const Scene& scene, std::span<const NodeId> ids);
/// Shows exactly the structures at or below the nodes: everything else is hidden, and groups above
/// the shown ones are made visible.
Edited withOnlyVisible(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
