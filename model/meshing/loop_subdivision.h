// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/geometry/mesh.h"
#include "model/meshing/vertex_rings.h"

namespace sline::model {

struct Subdivided {
  std::vector<glm::vec3> positions;  ///< the first ones are the moved old vertices, in their order
  std::vector<Triangle> triangles;   ///< four for each old one
};

/// One step of C. Loop, "Smooth Subdivision Surfaces Based on Triangles" (1987). Open edges follow
/// the cubic B-spline rule; edges of three or more triangles and corners where other than two such
/// edges meet stay where they are.
Subdivided loopSubdivided(const std::vector<glm::vec3>& positions,
                          const std::vector<Triangle>& triangles);

/// Where endless subdivision would take each vertex; border vertices stay.
std::vector<glm::vec3> limitPositions(const std::vector<glm::vec3>& positions,
                                      const VertexRings& rings);

/// Loop's scheme shrinks coarse surfaces (a thigh bone of 1,500 faces by 15 mm). Control points
/// moved outward by the error of their limit, again and again, undo that: F. Cheng et al., "Loop
/// Subdivision Surface Based Progressive Interpolation" (2009). A few rounds only, so that the
/// noise of the coarse vertices is not followed.
std::vector<glm::vec3> interpolatingControl(const std::vector<glm::vec3>& positions,
                                            const VertexRings& rings);

/// How far each old vertex is from its new place, at most.
float farthestMove(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& after);

}  // namespace sline::model
