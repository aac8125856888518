// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/photic_extrema.h"

#include "render/lines/ground/headlight.h"
#include "render/lines/techniques/zero_lines.h"

namespace sline::render {

void extractPhoticExtrema(const ClusterWalk& walk, const LineRequest& request,
                          std::vector<Segment>& segments) {
  const model::Surface& surface = walk.surface();
  ZeroLines lines(walk,
                  {.least = request.thresholds.of(LineKind::photic, leastPhoticSlope),
                   .twoSided = request.twoSided},
                  [&](std::uint32_t vertex) -> ZeroSample {
                    const Headlight f = headlightAt(surface, vertex, walk.eye());
                    return {.value = f.along(f.gradient),
                            .strength = glm::length(f.gradient) * surface.featureSize,
                            .falls = inSpace(surface, vertex, f.gradient)};
                  });
  lines.extract(segments);
}

}  // namespace sline::render
