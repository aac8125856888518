// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/bounded_relaxation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/parallel.h"

namespace sline::model {

void limitMoves(std::vector<glm::vec3>& after, std::span<const glm::vec3> before,
                std::span<const float> limits) {
  parallelFor(after.size(), 3072, [&](std::size_t v) {
    const glm::vec3 move = after[v] - before[v];
    const float length = glm::length(move);
    if (!(length <= limits[v]))
      after[v] = length > 0.0f && std::isfinite(length) ? before[v] + move * (limits[v] / length)
                                                        : before[v];
  });
}

void relaxWithin(std::vector<glm::vec3>& positions, std::span<const glm::vec3> before,
                 std::span<const float> limits, const VertexRings& rings) {
  constexpr int rounds = 20;
  constexpr float shrink = 0.6307f;  // Taubin's example: pass band 0.1
  constexpr float inflate = -0.6732f;
  std::vector<glm::vec3> next(positions.size());
  const auto step = [&](float weight) {
    parallelFor(positions.size(), 3072, [&](std::size_t v) {
      next[v] = positions[v];
      if (rings.onBorder(v) || rings[v].empty())
        return;
      glm::vec3 sum(0.0f);
      for (const std::uint32_t other : rings[v])
        sum += positions[other];
      next[v] += weight * (sum / float(rings[v].size()) - positions[v]);
    });
    std::swap(positions, next);
  };
  for (int round = 0; round < rounds; ++round) {
    step(shrink);
    step(inflate);
    limitMoves(positions, before, limits);
  }
}

}  // namespace sline::model
