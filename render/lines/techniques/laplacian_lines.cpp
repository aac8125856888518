// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/laplacian_lines.h"

#include "render/lines/ground/headlight.h"
#include "render/lines/techniques/zero_lines.h"

namespace sline::render {

void extractLaplacianLines(const ClusterWalk& walk, const LineRequest& request,
                           std::vector<Segment>& segments) {
  const model::Surface& surface = walk.surface();
  ZeroLines lines(walk,
                  {.least = request.thresholds.of(LineKind::laplacian, leastLaplacianSlope),
                   .twoSided = request.twoSided},
                  [&](std::uint32_t vertex) -> ZeroSample {
                    const Headlight f = headlightAt(surface, vertex, walk.eye());
                    return {.value = f.laplacian(),
                            .strength = glm::length(f.gradient) * surface.featureSize};
                  });
  lines.extract(segments);
}

}  // namespace sline::render
