// SPDX-License-Identifier: Apache-2.0
// Finds structures that lie on the other side of the body than their names say.
#pragma once

#include <string>
#include <vector>

#include "model/import/naming/laterality.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Holds the structures of a scene whose coordinates have sides, as the vote sees them.
struct SidedPlaces {
  std::vector<NodeId> ids;
  std::vector<NamedPosition> places;  ///< in LPS, millimetres; one for each id
};
SidedPlaces sidedPlaces(const Scene& scene);

/// Returns those that lie wholly on the other side than their names say (laterality.h), in order:
/// of a pair both, as one cannot tell which of them it is.
std::vector<NodeId> onOtherSide(const Scene& scene);

/// Says so in a sentence; empty where there are none. What contradicts its file's frame as a whole
/// is left out, as its import tells that.
std::string otherSidesText(const Scene& scene);

}  // namespace sline::model
