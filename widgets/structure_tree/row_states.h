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

/// Whether a row is locked, and by whom.
enum class RowLock { open, above, own };

/// All of a row but its name.
struct RowState {
  model::Shown shown = model::Shown::none;   ///< as model::shownOf
  std::vector<Colour> colours;               ///< the first few of the structures there, each once
  model::GammaRange gamma;                   ///< as model::gammaRangeOf
  Opacity opacity = Opacity::clamped(1.0f);  ///< of the faintest structure there
  bool ownGamma = false;                     ///< the node says Γ itself
  bool ownColour = false;
  bool ownOpacity = false;
  bool group = false;
  RowLock lock = RowLock::open;
  std::size_t structures = 0;  ///< at or below the node
  bool operator==(const RowState&) const = default;
};

/// By the ids of the nodes.
using RowStates = std::unordered_map<std::uint64_t, RowState>;
RowStates rowStatesOf(const model::Scene& scene);

}  // namespace sline::widgets
