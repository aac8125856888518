// SPDX-License-Identifier: Apache-2.0
// How a structure is told: as contours or as outer edges under a veil. What is said of a group
// holds for all in it; what is locked keeps its look (model/edit/locks.h).
#pragma once

#include <span>

#include "model/edit/edited.h"

namespace sline::model {

/// Γ of the visible structures at or below a node, or of all where none is visible.
struct GammaRange {
  Gamma low;
  Gamma high;
  bool operator==(const GammaRange&) const = default;
};
GammaRange gammaRangeOf(const Scene& scene, NodeId id);

/// The nodes as contours under a veil; everything else stays.
Edited withContext(const Scene& scene, std::span<const NodeId> ids);
/// The nodes as their outer edges alone, under a veil; everything else stays.
Edited withGhost(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
