// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/bounded_relaxation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/parallel.h"
#include "model/fairing/wide_vectors.h"

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
  std::vector<glm::vec4> now = widened(positions);
  std::vector<glm::vec4> next(now.size());
  const auto stepped = [&](std::size_t v, float weight) {
    return rings.onBorder(v) || rings[v].empty()
               ? now[v]
               : now[v] + weight * (ringMean(now, rings[v]) - now[v]);
  };
  for (int round = 0; round < rounds; ++round) {
    parallelFor(now.size(), 3072, [&](std::size_t v) { next[v] = stepped(v, shrink); });
    std::swap(now, next);
    parallelFor(now.size(), 3072, [&](std::size_t v) {
      next[v] = limited(stepped(v, inflate), glm::vec4(before[v], 0.0f), limits[v]);
    });
    std::swap(now, next);
  }
  positions = narrowed(now);
}

}  // namespace sline::model
