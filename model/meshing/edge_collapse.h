// SPDX-License-Identifier: Apache-2.0
// Fewer triangles by drawing edges together: Garland and Heckbert, "Surface simplification using
// quadric error metrics", SIGGRAPH 1997; in OpenMesh's framework of decimaters and their modules.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

struct Collapsed {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Draws edges together, cheapest first, while the root mean square distance of the new vertex from
/// the planes it stands for (mm, weighted by area) is at most the tolerance of both its vertices.
/// Vertices on an edge that has not exactly two triangles, or around which the triangles are no
/// single fan, stay where they are; no edge is drawn together that would change what is connected
/// with what (link condition: Dey, Edelsbrunner, Guha and Nekhayev, "Topology preserving edge
/// contraction", 1999) or would turn a triangle over. One tolerance for each vertex. Empty where
/// `goesOn` said no.
Collapsed withEdgesCollapsed(const Mesh& mesh, std::span<const float> tolerances,
                             const std::function<bool()>& goesOn);

}  // namespace sline::model
