// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// A sample is a place on a surface and the outward unit normal of its triangle.
struct SurfaceSample {
  glm::vec3 place{0.0f};
  glm::vec3 normal{0.0f};
};

/// Returns points spread evenly over the area, whatever the size of the triangles; always the same
/// for the same mesh, and mirrored for its mirror image. None where the mesh has no area.
std::vector<SurfaceSample> surfaceSamples(const Mesh& mesh, std::size_t count);

/// Returns the area in mm².
double surfaceArea(const Mesh& mesh);

}  // namespace sline::model
