// SPDX-License-Identifier: Apache-2.0
// From what was measured to what a structure is.
#pragma once

#include "model/focus/analysis.h"
#include "model/focus/surroundings.h"

namespace sline::model {

/// How much of a vessel that comes to the targets a structure is.
struct Feeding {
  float direct = 0.0f;  ///< 0 … 1
  float stem = 0.0f;    ///< that it is one such vessel's stem
  NodeId through;       ///< that vessel
};

/// For each party.
std::vector<Feeding> feedings(const Surroundings& surroundings, std::span<const Party> parties,
                              std::span<const Facts> facts, const std::stop_token& stop);

Relation relationOf(const Surroundings& surroundings, const Party& party, const Facts& facts,
                    const Feeding& feeding);

}  // namespace sline::model
