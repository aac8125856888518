// SPDX-License-Identifier: Apache-2.0
#include "render/software/placed_clusters.h"

#include <algorithm>

#include "render/drawn/section_caps.h"
#include "render/strokes/coverage.h"

namespace sline::render {

ReadyMember::ReadyMember(const RasterMember& member, const RasterSight& sight)
    : shown(&member.shown),
      clusters(&member.clusters),
      shading(member.fill, sight.key),
      cull(cullsBack(member.shown, sight.view)) {
  if (member.shown.cut)
    planes = sectionVectors(member.shown.cut->planes);
}

std::vector<PlacedCluster> placedClusters(std::span<const ReadyMember> members,
                                          const RasterSight& sight) {
  const SampleArea& samples = sight.samples;
  std::vector<PlacedCluster> clusters;
  for (std::size_t m = 0; m < members.size(); ++m)
    for (const model::Cluster& cluster : members[m].clusters->items) {
      if (members[m].cull && model::facing(cluster, sight.view.eye()) == model::Facing::back)
        continue;
      if (isCutAway(*members[m].shown, cluster.bounds))
        continue;
      const PixelRect bounds = sight.view.bounds(cluster.bounds);
      if (!sight.squares.marksAny(bounds))
        continue;
      // One more on each side: drivers and the bounds round.
      const PixelRect rows =
          coarser({bounds.x - samples.grid.corner.x, bounds.y - samples.grid.corner.y, bounds.width,
                   bounds.height},
                  samples.grid.step);
      clusters.push_back({&cluster, std::uint16_t(m), std::max(rows.y - 1 - samples.area.y, 0),
                          std::min(rows.top() + 1 - samples.area.y, samples.area.height)});
    }
  return clusters;
}

}  // namespace sline::render
