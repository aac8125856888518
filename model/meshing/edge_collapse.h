// SPDX-License-Identifier: Apache-2.0
// Reduces triangles by collapsing edges: Garland and Heckbert, "Surface simplification using
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

/// Collapses edges, cheapest first, while the root mean square distance of the new vertex from the
/// planes it stands for (mm, weighted by area) is at most the tolerance of both its vertices.
/// Vertices on an edge that has not exactly two triangles, or around which the triangles are no
/// single fan, stay where they are; no edge is collapsed that would change the connectivity of the
/// surface (link condition: Dey, Edelsbrunner, Guha and Nekhayev, "Topology preserving edge
/// contraction", 1999) or would turn a triangle over. There is one tolerance for each vertex. The
/// result is empty where `goesOn` returned false.
Collapsed withEdgesCollapsed(const Mesh& mesh, std::span<const float> tolerances,
                             const std::function<bool()>& goesOn);

}  // namespace sline::model
