// SPDX-License-Identifier: Apache-2.0
// Chooses structures by what they are to those that are selected. Selections may name groups, which
// mean all that is in them; results are structures in tree order.
#pragma once

#include <span>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Returns the structures that a hand can select in the picture: shown and not locked.
std::vector<NodeId> selectable(const Scene& scene);
/// Returns those of the selectable ones that are not selected.
std::vector<NodeId> withoutSelected(const Scene& scene, std::span<const NodeId> selection);
/// Returns the selected structures and the selectable ones whose names differ from one of theirs by
/// side or numbers alone; where all of these are selected, those of their systems (model/anatomy).
std::vector<NodeId> ofSameKind(const Scene& scene, std::span<const NodeId> selection);
/// Returns the selectable structures that have a selected one's name with the other side.
std::vector<NodeId> onOtherSide(const Scene& scene, std::span<const NodeId> selection);

}  // namespace sline::model
