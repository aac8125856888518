// SPDX-License-Identifier: Apache-2.0
// Cuts a surface by a plane: the line of the cut, and the face that closes a solid there.
#pragma once

#include <vector>

#include "model/geometry/plane.h"
#include "model/geometry/surface.h"

namespace sline::model {

/// Holds the piece of the cut within one triangle; neighbours share their ends to the last bit.
struct CutSegment {
  glm::vec3 a{0.0f};
  glm::vec3 b{0.0f};
  glm::vec3 normalA{0.0f};  ///< interpolated unit normals of the surface
  glm::vec3 normalB{0.0f};
  std::uint32_t triangle = 0;
};

struct PlaneSection {
  std::vector<CutSegment> segments;
  /// Three points per triangle, counter-clockwise seen from the side that is taken away; none for a
  /// surface that is not solid. Filled by the odd-even rule, so cavities stay open.
  std::vector<glm::vec3> cap;
  double capArea = 0.0;  ///< mm²
};

/// Returns the section, computed in parallel; the order of segments depends on surface and plane
/// alone. Lines end at the rims of sheets; in a solid, gaps left by specks are bridged to the
/// nearest end.
PlaneSection planeSection(const Surface& surface, const Plane& plane);

/// Returns the area of a closed mesh's section, mm², without its line or face: cavities count as
/// holes. Of an open mesh it is no more than a guess.
double sectionArea(const Mesh& mesh, const Plane& plane);

/// Returns all vertices that the planes keep, and the points where edges cross a plane and the
/// other planes keep them: the points of the mesh that a camera must show. Without planes it
/// returns all vertices.
std::vector<glm::vec3> keptPoints(const Mesh& mesh, std::span<const Plane> planes);

}  // namespace sline::model
