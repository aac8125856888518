// SPDX-License-Identifier: Apache-2.0
// What the tree's rows show, worked out for a whole scene at once: asking node by node would look
// at all below each group again, which a body of a thousand structures makes long.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "model/edit/emphasis.h"
#include "model/edit/visibility.h"

namespace sline::widgets {

/// All of a row but its name.
struct RowState {
  model::Shown shown = model::Shown::none;  ///< as model::shownOf
  std::vector<Colour> colours;              ///< the first few of the structures there, each once
  model::GammaRange gamma;                  ///< as model::gammaRangeOf
  bool ownGamma = false;                    ///< the node says Γ itself
  std::size_t structures = 0;               ///< at or below the node
  bool operator==(const RowState&) const = default;
};

/// By the ids of the nodes.
using RowStates = std::unordered_map<std::uint64_t, RowState>;
RowStates rowStatesOf(const model::Scene& scene);

}  // namespace sline::widgets
