// SPDX-License-Identifier: Apache-2.0
#include "model/scalars/ring_diffusion.h"

#include "model/base/parallel.h"

namespace sline::model {

void diffuse(const VertexRings& rings, int steps, std::vector<glm::vec2>& values) {
  constexpr std::size_t grain = 8192;
  std::vector<glm::vec2> next(values.size());
  for (int step = 0; step < steps; ++step) {
    parallelFor(values.size(), grain, [&](std::size_t v) {
      glm::vec2 sum(0.0f);
      for (const std::uint32_t other : rings[v])
        sum += values[other];
      const std::size_t count = rings[v].size();
      next[v] = count > 0 ? 0.5f * (values[v] + sum / float(count)) : values[v];
    });
    values.swap(next);
  }
}

}  // namespace sline::model
