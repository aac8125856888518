// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the triangles of the mesh so that each `Clusters::maximumTriangles` in a row are
/// neighbours in space that face alike: a spatial order whose stretches are halved again and again
/// where their centroids or normals spread most.
std::vector<std::uint32_t> clusterOrder(const Mesh& mesh);

}  // namespace sline::model
