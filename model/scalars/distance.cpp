// SPDX-License-Identifier: Apache-2.0
#include "model/scalars/distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"
#include "model/geometry/mesh_trees.h"

namespace sline::model {

std::vector<float> distancesTo(std::span<const MeshPtr> targets,
                               std::span<const glm::vec3> points) {
  std::vector<BvhPtr> trees;
  trees.reserve(targets.size());
  for (const MeshPtr& mesh : targets)
    trees.push_back(treeOf(mesh));
  constexpr float none = std::numeric_limits<float>::infinity();
  std::vector<float> distances(points.size(), none);
  parallelChunks(points.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // No point lies farther than its neighbour and the way there, which spares most of a search.
      // The margin is for rounding.
      float most = none;
      if (i > begin && std::isfinite(distances[i - 1]))
        most = 1.001f * (distances[i - 1] + glm::distance(points[i - 1], points[i])) + 1e-6f;
      for (const BvhPtr& tree : trees) {
        distances[i] = std::min(distances[i], tree->closest(points[i], 0.0f, most).distance);
        most = std::min(most, distances[i]);
      }
    }
  });
  return distances;
}

}  // namespace sline::model
