// SPDX-License-Identifier: Apache-2.0
#include "model/scalars/ring_diffusion.h"

namespace sline::model {

void diffuse(const VertexRings& rings, int steps, std::vector<glm::vec2>& values) {
  std::vector<glm::vec2> next(values.size());
  for (int step = 0; step < steps; ++step) {
    rings.forEach([&](std::size_t v, const auto& ring) {
      glm::vec2 sum(0.0f);
      for (const std::uint32_t other : ring)
        sum += values[other];
      const std::size_t count = ring.size();
      next[v] = count > 0 ? 0.5f * (values[v] + sum / float(count)) : values[v];
    });
    values.swap(next);
  }
}

}  // namespace sline::model
