// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/fairing/vertex_rings.h"
#include "model/geometry/mesh.h"

namespace sline::model {

struct Subdivided {
  std::vector<glm::vec3> positions;  ///< first the moved old vertices, in their order
  std::vector<Triangle> triangles;   ///< four for each old one
};

/// Applies one step of C. Loop, "Smooth Subdivision Surfaces Based on Triangles" (1987). Open edges
/// follow the cubic B-spline rule; edges of three or more triangles, and corners where the number
/// of such edges is not two, stay where they are.
Subdivided loopSubdivided(const std::vector<glm::vec3>& positions,
                          const std::vector<Triangle>& triangles);

/// Returns the positions to which endless subdivision would take the vertices; border vertices
/// stay.
std::vector<glm::vec3> limitPositions(const std::vector<glm::vec3>& positions,
                                      const VertexRings& rings);

/// Returns control points that counter the shrinking of Loop's scheme, which shrinks coarse
/// surfaces (a thigh bone of 1,500 faces by 15 mm): they are moved outward by the error of their
/// limit, again and again, as in F. Cheng et al., "Loop Subdivision Surface Based Progressive
/// Interpolation" (2009). It takes only a few rounds, so that the noise of the coarse vertices is
/// not followed.
std::vector<glm::vec3> interpolatingControl(const std::vector<glm::vec3>& positions,
                                            const VertexRings& rings);

/// Returns the largest distance of an old vertex from its new place.
float farthestMove(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& after);

}  // namespace sline::model
