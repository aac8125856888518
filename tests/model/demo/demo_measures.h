// SPDX-License-Identifier: Apache-2.0
// Measures modelled anatomy for tests to compare.
#pragma once

#include <filesystem>
#include <vector>

#include "model/geometry/bvh.h"
#include "model/geometry/mesh.h"

namespace sline::test {

/// Returns the volume in mm³; positive if the triangles face outwards.
double volumeOf(const model::Mesh& mesh);

/// Returns the volume of each connected part, the largest first; a cavity's is negative.
std::vector<double> volumesOfParts(const model::Mesh& mesh);

/// Returns how many handles a closed mesh of one piece has: 0 for a ball or a cup, 1 for a ring or
/// a pipe open at both ends, 2 if one more opening is added.
int handlesOf(const model::Mesh& mesh);

/// Tells whether a ray from the point leaves the closed mesh an odd number of times.
bool inside(const model::Bvh& bvh, const glm::vec3& p);

/// Returns the root mean square of the distances of a body's vertices, as a share of the radius,
/// from the ellipsoid with the body's second moments: 0 for an ellipsoid.
double misfitOfBestEllipsoid(const model::Mesh& mesh);

/// Returns the bounds of the vertices of an OBJ file, in its own coordinates, down to a height
/// below which the body is not compared.
model::Box boundsOfObj(const std::filesystem::path& file, float lowest = -1e9f);

/// A Solid is a closed mesh that can be asked what lies inside.
class Solid {
 public:
  explicit Solid(model::MeshPtr mesh);
  bool contains(const glm::vec3& p) const;
  /// Returns the share of the other body's vertices that lie inside this one. Two bodies that
  /// overlap by a share of their volume do so by a far larger share of their surface.
  double shareOf(const model::Mesh& other) const;

 private:
  model::MeshPtr m_mesh;
  model::Bvh m_bvh;
};

}  // namespace sline::test
