// SPDX-License-Identifier: Apache-2.0
// Derives each structure's role from the measurements.
#pragma once

#include "model/focus/analysis.h"
#include "model/focus/surroundings.h"

namespace sline::model {

/// Says how far a structure is a vessel that comes to the targets.
struct Feeding {
  float direct = 0.0f;  ///< 0 … 1
  float stem = 0.0f;    ///< how surely it is the stem of one such vessel
  NodeId through;       ///< that vessel
};

/// Returns the feeding of each party.
std::vector<Feeding> feedings(const Surroundings& surroundings, std::span<const Party> parties,
                              std::span<const Facts> facts, const std::stop_token& stop);

Relation relationOf(const Surroundings& surroundings, const Party& party, const Facts& facts,
                    const Feeding& feeding);

}  // namespace sline::model
