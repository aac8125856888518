// SPDX-License-Identifier: Apache-2.0
// Measures between two structures.
#pragma once

#include <optional>

#include "model/lengths/told_length.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns a distance without words from one structure to another: between the points where their
/// surfaces are nearest to each other or, with a place, from the point of the first that is nearest
/// to it to the nearest of the second. Nothing where one of them has no surface. Takes long on
/// large meshes.
std::optional<Annotation> shortestDistance(const Scene& scene, NodeId from, NodeId to,
                                           const std::optional<glm::vec3>& at = std::nullopt);

/// Returns how long a distance is as it is drawn, in mm of the patient's frame: 0 between two
/// structures that touch as far as such surfaces can tell, which is within 1/2000 of the smaller
/// one's extent and 0.05 mm; and how far import has moved the surfaces on which its ends lie.
/// Nothing for other annotations and where an end has no place.
std::optional<DrawnLength> drawnLength(const Scene& scene, const Annotation& annotation);

}  // namespace sline::model
