// SPDX-License-Identifier: Apache-2.0
// Draws everything by how near it is to the focus: Γ falls off with the distance, along each
// surface, from shading through hatching to silhouettes. It is quick, so that a picture can follow
// a place that is dragged.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "model/edit/edited.h"
#include "model/geometry/mesh_trees.h"

namespace sline::model {

/// Says what everything is to be near to: structures and groups or, with a place in `nearness`,
/// that place.
struct NearFocus {
  std::vector<NodeId> targets;
  FocusNearness nearness;
};

/// Returns the falloff that suits what is shown of the scene, be it a body or a molecule.
float usualFalloffMm(const Scene& scene);

/// Returns the curve of a distance by which Γ falls off, for structures of Γ 0.
std::vector<GammaPoint> falloffCurve(float falloffMm);

/// Returns the structures that are shown and, seen by the camera, lie before the targets, or before
/// what is near the place, and hide much of it; sections count. A structure on which the place lies
/// is none of them.
std::set<NodeId> structuresBefore(const Scene& scene, const NearFocus& focus, const Camera& camera,
                                  MeshTrees& trees);

/// Draws the targets shaded, those of `before` as outlines that hide nothing, and all others by the
/// distance, as solids. Structures that are hidden or locked stay as they are, but targets are
/// shown, and so are those that an earlier focus has faded out. The scene's focus says all this.
Edited withNearFocus(const Scene& scene, const NearFocus& focus, const std::set<NodeId>& before);

/// Takes away that Γ follows the distance from the focus; all else stays. The scene's focus is none
/// of nearness then.
Edited withoutNearness(const Scene& scene);

/// Returns what the scene's focus is near to, or nothing where it is not one of nearness.
std::optional<NearFocus> nearFocusOf(const Scene& scene);

}  // namespace sline::model
