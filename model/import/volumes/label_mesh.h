// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/import/volumes/label_sheets.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

/// Holds one structure's closed surface in triangles, counter-clockwise seen from outside.
struct LabelMesh {
  std::vector<std::uint32_t> points;  ///< for the first vertices; further ones lie between them
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Returns the surface of label n (1 …) with the sheets' points at `at`. Every edge has two
/// triangles: where two sheets would share one, each has a vertex of its own in the middle.
LabelMesh labelMesh(const VoxelBox& box, const SurfaceNet& net, const LabelSheets& sheets,
                    std::size_t label, std::span<const glm::vec3> at);

}  // namespace sline::model
