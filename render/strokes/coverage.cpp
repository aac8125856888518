// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/coverage.h"

#include <cmath>

#include "render/strokes/line_curves.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

bool cullsBack(const DrawnStructure& shown, const PictureView& view) {
  return !needsTwoSides(shown.surface(), view.camera());
}

int strokeReach(const DrawnStructure& shown, const PictureView& view) {
  if (!showsLines(shown.style) && !showsEdges(shown.style))
    return edgeMargin;
  const ContourProbes probes = contourProbes(shown.surface(), view, shown.style);
  return int(std::ceil(2.0f * probes.probe + probes.reach.y + curveBound * view.outputUnit())) + 3;
}

PixelRect coveredArea(const DrawnStructure& shown, const PictureView& view,
                      const PixelRect& within) {
  PixelRect area;
  if (isCutAway(shown, shown.mesh->bounds()))
    return area;
  forEachSeen(shown, view, within,
              [&](const model::Cluster&, const PixelRect& seen) { area = united(area, seen); });
  if (shown.cut)
    area = united(area,
                  intersection(grown(sectionArea(shown, view), strokeReach(shown, view)), within));
  return area;
}

}  // namespace sline::render
