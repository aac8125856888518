// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the unit outward vertex normals, one per vertex, weighted as in N. Max, "Weights for
/// Computing Vertex Normals from Facet Normals" (1999): exact on a sphere. Faces without area
/// contribute nothing; a vertex without faces gets (0, 0, 0).
std::vector<glm::vec3> vertexNormals(const Mesh& mesh);

}  // namespace sline::model
