// SPDX-License-Identifier: Apache-2.0
// Changes the emphasis of structures, to contours or to outer edges under a veil. A change to a
// group applies to everything in it; locked nodes keep their look (model/edit/locks.h).
#pragma once

#include <span>

#include "model/edit/edited.h"

namespace sline::model {

/// Holds the range of Γ of the visible structures at or below a node, or of all structures there if
/// none is visible.
struct GammaRange {
  Gamma low;
  Gamma high;
  bool operator==(const GammaRange&) const = default;
};
GammaRange gammaRangeOf(const Scene& scene, NodeId id);

/// Draws the nodes as contours under a veil; everything else stays.
Edited withContext(const Scene& scene, std::span<const NodeId> ids);
/// Draws the nodes as their outer edges alone, under a veil; everything else stays.
Edited withGhost(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
