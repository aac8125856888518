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

/// Returns those of them whose names are in doubt for it: not where all of a file contradicts its
/// frame, which its import tells, nor where somebody has said that the name is right.
std::vector<NodeId> withNameInDoubt(const Scene& scene);

/// Says of those in a sentence where they lie; empty where there are none.
std::string otherSidesText(const Scene& scene);

/// Marks the names that are in doubt in what is imported, which stands last in the scene that it
/// comes into.
void markNamesInDoubt(Scene& imported, const Scene& whole);

}  // namespace sline::model
