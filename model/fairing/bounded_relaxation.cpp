// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/bounded_relaxation.h"

#include <cmath>
#include <utility>

#include "model/base/parallel.h"
#include "model/fairing/wide_vectors.h"

namespace sline::model {

namespace {

/// Returns where the vertex may go of where it went.
[[gnu::always_inline]] inline Lanes limited(Lanes after, Lanes before, float limit) {
  const Lanes move = after - before;
  const float squared = move[0] * move[0] + move[1] * move[1] + move[2] * move[2];
  if (squared <= limit * limit)
    return after;
  const float length = std::sqrt(squared);
  return length > 0.0f && std::isfinite(length) ? before + move * (limit / length) : before;
}

}  // namespace

void limitMoves(std::vector<glm::vec3>& after, std::span<const glm::vec3> before,
                std::span<const float> limits) {
  parallelFor(after.size(), 3072, [&](std::size_t v) {
    after[v] = narrowed(limited(widened(after[v]), widened(before[v]), limits[v]));
  });
}

void relaxWithin(std::vector<glm::vec3>& positions, std::span<const glm::vec3> before,
                 std::span<const float> limits, const VertexRings& rings) {
  constexpr int rounds = 20;
  constexpr float shrink = 0.6307f;  // Taubin's example: pass band 0.1
  constexpr float inflate = -0.6732f;
  std::vector<Lanes> now = widened(positions);
  std::vector<Lanes> next(now.size());
  const auto stepped = [&](std::size_t v, const auto& ring, float weight) {
    return rings.onBorder(v) || ring.empty() ? now[v]
                                             : now[v] + weight * (ringMean(now, ring) - now[v]);
  };
  for (int round = 0; round < rounds; ++round) {
    rings.forEach([&](std::size_t v, const auto& ring) { next[v] = stepped(v, ring, shrink); });
    std::swap(now, next);
    rings.forEach([&](std::size_t v, const auto& ring) {
      next[v] = limited(stepped(v, ring, inflate), widened(before[v]), limits[v]);
    });
    std::swap(now, next);
  }
  positions = narrowed(now);
}

}  // namespace sline::model
