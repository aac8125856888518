// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the triangles of the mesh along a Z-order curve through their centroids: neighbours in
/// the list are neighbours in space. The bounding-volume hierarchy cuts this list, and so do
/// clusters, which order its stretches once more (cluster_order.h).
std::vector<std::uint32_t> spatialOrder(const Mesh& mesh);

}  // namespace sline::model
