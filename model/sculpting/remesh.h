// SPDX-License-Identifier: Apache-2.0
// Turns the uneven triangles of a lattice into an even mesh (Botsch and Kobbelt, "A remeshing
// approach to multiresolution modeling", 2004): curvature is computed from triangles, and the
// lattice's slivers would show as a pattern of short strokes on the smoothest tube.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds triangles that are to become a mesh; they are closed, each edge shared by two.
struct Facets {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Collapses edges shorter than `shortest`, unless an edge longer than `longest` or a fold would
/// result. It makes one pass; vertices beside a changed one wait for the next.
void drawTogether(Facets& facets, float shortest, float longest);

/// Turns edges within pairs of nearly coplanar triangles so that more vertices get six neighbours.
/// It makes one pass, as above.
void turnEdges(Facets& facets);

}  // namespace sline::model
