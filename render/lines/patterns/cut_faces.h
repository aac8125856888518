// SPDX-License-Identifier: Apache-2.0
// Cuts a surface by section planes: each plane gives a face and the lines around it.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/plane.h"
#include "model/geometry/surface.h"
#include "render/lines/ground/segments.h"

namespace sline::render {

struct CutFace {
  model::Plane plane;
  /// The line of the cut and, in a solid, the corners with the faces of later planes; clipped by
  /// all other planes. It does not depend on the view.
  std::vector<Segment> outline;
  /// Triangles as in model::PlaneSection, not clipped by the other planes; empty for a sheet.
  std::vector<glm::vec3> cap;
  double capArea = 0.0;  ///< mm², before the other planes clip it
};

/// Returns one face per plane, in the planes' order.
std::vector<CutFace> cutFaces(const model::Surface& surface, std::span<const model::Plane> planes);

/// Returns all planes but the one of that index, moved outwards by a hair of the surface's size.
/// They clip the face of that plane, even where two planes are the same.
std::vector<model::Plane> otherPlanes(const model::Surface& surface,
                                      std::span<const model::Plane> planes, std::size_t index);

}  // namespace sline::render
