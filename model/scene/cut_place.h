// SPDX-License-Identifier: Apache-2.0
// Labels on the faces of cuts. Such a place is on no surface, and yet of the structure that was
// cut: the label has two anchors, the nearest place on the structure's surface, by which it belongs
// to it, and the place itself, in space.
#pragma once

#include <span>

#include "model/scene/scene.h"

namespace sline::model {

/// Returns the place on a face of a cut at which the label, callout or pin was set; null for
/// others.
const glm::vec3* cutPlaceOf(const Annotation& annotation);

/// Returns the anchors of a label at that place of a cut through the structure; of one in space
/// where it has no surface.
std::vector<Anchor> anchorsOnCut(const Node& structure, const glm::vec3& place);

/// Returns the anchors at which the annotation points: both of a distance, else one.
std::span<const Anchor> pointedAt(const Annotation& annotation);

/// Tells whether the scene's sections cut the structure there: the place is on the plane of one of
/// them, and none takes it away.
bool cutsThrough(const Scene& scene, NodeId structure, const glm::vec3& place);

}  // namespace sline::model
