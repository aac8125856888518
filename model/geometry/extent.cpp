// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/extent.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/topology.h"

namespace sline::model {

Extent extentOf(const Mesh& mesh) {
  // Coordinates are taken from the middle of the box, since a mesh far from the origin would lose
  // its digits.
  const glm::dvec3 origin =
      mesh.bounds().empty() ? glm::dvec3(0.0) : glm::dvec3(mesh.bounds().centre());
  double area = 0.0;
  double volume = 0.0;
  for (const Triangle& triangle : mesh.triangles()) {
    const glm::dvec3 a = glm::dvec3(mesh.positions()[triangle[0]]) - origin;
    const glm::dvec3 b = glm::dvec3(mesh.positions()[triangle[1]]) - origin;
    const glm::dvec3 c = glm::dvec3(mesh.positions()[triangle[2]]) - origin;
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  Extent extent{.area = area};
  if (mesh.triangleCount() > 0 && countEdges(mesh, VertexFaces(mesh)).closed())
    extent.volume = std::abs(volume);
  return extent;
}

}  // namespace sline::model
