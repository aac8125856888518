// SPDX-License-Identifier: Apache-2.0
// Finds which pixels a structure and its strokes can touch, from the surface's clusters alone.
#pragma once

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_view.h"
#include "render/drawn/section_caps.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// The pixels by which a fill reaches beyond its surface, soft edge included.
inline constexpr int edgeMargin = 2;

/// Returns whether only the parts of the surface that face the eye are drawn.
bool cullsBack(const DrawnStructure& shown, const PictureView& view);

/// Returns how many pixels around the surface can matter to its strokes and to their tests beside
/// themselves.
int strokeReach(const DrawnStructure& shown, const PictureView& view);

/// Calls `body(cluster, pixels)` for the clusters that may show in `within`, each with the pixels
/// there that it can touch.
template <class Body>
void forEachSeen(const DrawnStructure& shown, const PictureView& view, const PixelRect& within,
                 const Body& body) {
  const bool cull = cullsBack(shown, view);
  const int around = strokeReach(shown, view);
  for (const model::Cluster& cluster : shown.surface().clusters.items) {
    if ((cull && model::facing(cluster, view.eye()) == model::Facing::back) ||
        isCutAway(shown, cluster.bounds))
      continue;
    const PixelRect seen = intersection(grown(view.bounds(cluster.bounds), around), within);
    if (!seen.empty())
      body(cluster, seen);
  }
}

/// Returns the pixels within `within` that the structure can touch. `within` should extend beyond
/// the picture by `strokeReach`, as lines at its edge look at pixels beside them.
PixelRect coveredArea(const DrawnStructure& shown, const PictureView& view,
                      const PixelRect& within);

}  // namespace sline::render
