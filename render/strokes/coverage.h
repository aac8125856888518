// SPDX-License-Identifier: Apache-2.0
// Which pixels a structure and its strokes can touch, from the surface's clusters alone.
#pragma once

#include "render/lines/lines.h"
#include "render/strokes/drawn_structure.h"
#include "render/strokes/picture_view.h"
#include "render/strokes/section_look.h"

namespace sline::render {

/// Pixels that a fill reaches beyond its surface, soft edge included.
inline constexpr int edgeMargin = 2;

/// Returns whether only what faces the eye is drawn of the surface.
bool cullsBack(const DrawnStructure& shown, const PictureView& view);

/// Returns how many pixels around the surface its strokes and their looks aside can reach.
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
        takenAway(shown, cluster.bounds))
      continue;
    const PixelRect seen = intersection(grown(view.bounds(cluster.bounds), around), within);
    if (!seen.empty())
      body(cluster, seen);
  }
}

/// Returns the pixels that the structure can touch, within `within`, which should go beyond the
/// picture by `strokeReach`: lines at its edge look beside them.
PixelRect coveredArea(const DrawnStructure& shown, const PictureView& view,
                      const PixelRect& within);

}  // namespace sline::render
