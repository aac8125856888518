// SPDX-License-Identifier: Apache-2.0
// Computes what the tree's rows show, for a whole scene at once: computing it node by node would
// visit everything below each group again, which takes long for a body of a thousand structures.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "model/edit/emphasis.h"
#include "model/edit/visibility.h"

namespace sline::widgets {

/// Tells whether a row is locked, and whether by a group above or by itself.
enum class RowLock { open, above, own };

/// Holds everything that a row shows except its name.
struct RowState {
  model::Visibility shown = model::Visibility::none;  ///< as model::visibilityOf
  std::vector<Colour> colours;               ///< the first few of the structures there, each once
  model::GammaRange gamma;                   ///< as model::gammaRangeOf
  Opacity opacity = Opacity::clamped(1.0f);  ///< of the faintest structure there
  bool ownGamma = false;                     ///< the node has a Γ of its own
  bool ownColour = false;
  bool ownOpacity = false;
  bool group = false;
  RowLock lock = RowLock::open;
  std::size_t structures = 0;  ///< at or below the node
  bool operator==(const RowState&) const = default;
};

/// The states by the ids of the nodes.
using RowStates = std::unordered_map<std::uint64_t, RowState>;
RowStates rowStatesOf(const model::Scene& scene);

}  // namespace sline::widgets
