// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/edge_length.h"

#include <glm/geometric.hpp>

namespace sline::model {

float meanEdgeLength(std::span<const glm::vec3> positions, std::span<const Triangle> triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += double(glm::distance(positions[t[k]], positions[t[(k + 1) % 3]]));
  return triangles.empty() ? 0.0f : float(sum / double(3 * triangles.size()));
}

}  // namespace sline::model
