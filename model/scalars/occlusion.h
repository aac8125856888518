// SPDX-License-Identifier: Apache-2.0
// Computes how much of the sky above each point of a surface the surface itself hides: cavities and
// docking pockets tell themselves from what lies open by it (METHOD §7; D. Borland, "Ambient
// Occlusion Opacity Mapping", WSCG 2011).
#pragma once

#include <vector>

#include "model/geometry/surface.h"

namespace sline::model {

/// Returns one value per vertex: the share of the directions on the normals' side, weighted by
/// their cosine to the normal, in which a ray meets the surface, however far away. 0: everything is
/// open, as on any convex body; 1: nothing is. Only the surface itself counts, no other structure,
/// so that a field stays when others are hidden or moved. Vertices without faces have 0.
///
/// On surfaces of many vertices rays start at an evenly spread part of them; the others take what a
/// smooth filter over the surface, not through space, makes of these. Equal surfaces have equal
/// values, whatever the number of threads.
std::vector<float> ambientOcclusion(const Surface& surface);

}  // namespace sline::model
