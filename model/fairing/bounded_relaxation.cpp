// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/bounded_relaxation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

/// Returns where the vertex may go of where it went.
template <class Vector>
Vector limited(const Vector& after, const Vector& before, float limit) {
  const Vector move = after - before;
  const float length = glm::length(move);
  if (length <= limit)
    return after;
  return length > 0.0f && std::isfinite(length) ? before + move * (limit / length) : before;
}

}  // namespace

void limitMoves(std::vector<glm::vec3>& after, std::span<const glm::vec3> before,
                std::span<const float> limits) {
  parallelFor(after.size(), 3072,
              [&](std::size_t v) { after[v] = limited(after[v], before[v], limits[v]); });
}

void relaxWithin(std::vector<glm::vec3>& positions, std::span<const glm::vec3> before,
                 std::span<const float> limits, const VertexRings& rings) {
  constexpr int rounds = 20;
  constexpr float shrink = 0.6307f;  // Taubin's example: pass band 0.1
  constexpr float inflate = -0.6732f;
  // Vectors of four are read and added in one go, those of three are not.
  std::vector<glm::vec4> now(positions.size());
  std::vector<glm::vec4> next(positions.size());
  for (std::size_t v = 0; v < now.size(); ++v)
    now[v] = glm::vec4(positions[v], 0.0f);
  const auto stepped = [&](std::size_t v, float weight) {
    if (rings.onBorder(v) || rings[v].empty())
      return now[v];
    glm::vec4 sum(0.0f);
    for (const std::uint32_t other : rings[v])
      sum += now[other];
    return now[v] + weight * (sum / float(rings[v].size()) - now[v]);
  };
  for (int round = 0; round < rounds; ++round) {
    parallelFor(now.size(), 3072, [&](std::size_t v) { next[v] = stepped(v, shrink); });
    std::swap(now, next);
    parallelFor(now.size(), 3072, [&](std::size_t v) {
      next[v] = limited(stepped(v, inflate), glm::vec4(before[v], 0.0f), limits[v]);
    });
    std::swap(now, next);
  }
  for (std::size_t v = 0; v < now.size(); ++v)
    positions[v] = glm::vec3(now[v]);
}

}  // namespace sline::model
