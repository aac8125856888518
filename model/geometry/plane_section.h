// SPDX-License-Identifier: Apache-2.0
// A surface cut by a plane: the line of the cut, and the face that closes a solid there.
#pragma once

#include <vector>

#include "model/geometry/plane.h"
#include "model/geometry/surface.h"

namespace sline::model {

/// A piece of the cut within one triangle; neighbours share their ends to the last bit.
struct CutSegment {
  glm::vec3 a{0.0f};
  glm::vec3 b{0.0f};
  glm::vec3 normalA{0.0f};  ///< the surface's interpolated unit normals
  glm::vec3 normalB{0.0f};
  std::uint32_t triangle = 0;
};

struct PlaneSection {
  std::vector<CutSegment> segments;
  /// Three points each, counter-clockwise seen from the side that is taken away; none for a surface
  /// that is not solid. Filled by the odd-even rule, so cavities stay open.
  std::vector<glm::vec3> cap;
  double capArea = 0.0;  ///< mm²
};

/// Parallel; the order of segments depends on surface and plane alone. Lines end at the rims of
/// sheets; in a solid the gaps that its specks leave are bridged to the nearest end.
PlaneSection planeSection(const Surface& surface, const Plane& plane);

/// All vertices that the planes keep, and the points where edges cross a plane and the others keep
/// them: what a camera must show of the mesh. Without planes all vertices.
std::vector<glm::vec3> keptPoints(const Mesh& mesh, std::span<const Plane> planes);

}  // namespace sline::model
