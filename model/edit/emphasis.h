// SPDX-License-Identifier: Apache-2.0
// How a structure is told: edits Scene → Scene (see model/edit/style.h for `Edited`). What is said
// of a group holds for all in it, so what structures in it said themselves is forgotten; they may
// say otherwise afterwards, and inherit again. What is locked keeps its look (model/edit/locks.h).
#pragma once

#include "model/edit/style.h"

namespace sline::model {

Edited withGamma(const Scene& scene, std::span<const NodeId> ids, Gamma gamma);
Edited withColour(const Scene& scene, std::span<const NodeId> ids, Colour colour);
Edited withFill(const Scene& scene, std::span<const NodeId> ids, Fill fill);
/// What is taken from the group above again; `all` is the whole look, but not whether it is shown.
enum class Inherited { gamma, colour, opacity, all };
/// For the nodes and all below them.
Edited withInherited(const Scene& scene, std::span<const NodeId> ids, Inherited what);
Edited withGammaInherited(const Scene& scene, std::span<const NodeId> ids);

/// Γ of the visible structures at or below a node, or of all where none is visible.
struct GammaRange {
  Gamma low;
  Gamma high;
  bool operator==(const GammaRange&) const = default;
};
GammaRange gammaRangeOf(const Scene& scene, NodeId id);

/// The nodes in detail (hatched and shaded); everything else as contours under a veil, through
/// which the nodes can be seen where they lie behind.
Edited withFocus(const Scene& scene, std::span<const NodeId> ids);
/// The nodes as contours under a veil; everything else stays.
Edited withContext(const Scene& scene, std::span<const NodeId> ids);
/// The nodes as their outer edges alone, under a veil; everything else stays.
Edited withGhost(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
