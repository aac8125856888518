// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_caps.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "render/drawn/section_caps.h"
#include "render/picture/layer.h"

namespace sline::render {

void markCaps(const PreparedStructure& shown, const PictureView& view, TileMask& mask) {
  for (const CutFace& face : shown.cut->faces)
    for (std::size_t i = 0; i + 2 < face.cap.size(); i += 3) {
      const std::array<PictureView::Point, 3> p{
          view.project(face.cap[i]), view.project(face.cap[i + 1]), view.project(face.cap[i + 2])};
      if (std::min({p[0].w, p[1].w, p[2].w}) <= 0.0f) {
        mask.mark(view.whole());
        continue;
      }
      const glm::vec2 limit(1e6f);
      const glm::vec2 low =
          glm::clamp(glm::min(glm::min(p[0].pixel, p[1].pixel), p[2].pixel) - 1.0f, -limit, limit);
      const glm::vec2 high =
          glm::clamp(glm::max(glm::max(p[0].pixel, p[1].pixel), p[2].pixel) + 2.0f, -limit, limit);
      mask.mark({int(low.x), int(low.y), int(high.x - low.x) + 1, int(high.y - low.y) + 1});
    }
}

CapDraws capDraws(const PreparedStructure& shown, const PictureView& view, Background background,
                  const PixelRect& area, const PixelRect& slot) {
  CapDraws result;
  CappedSurface& cut = *shown.capped;
  result.planes.resize(cut.faces.size());
  for (std::size_t i = 0; i < cut.faces.size(); ++i) {
    if (cut.faces[i].cap.empty())
      continue;
    if (!cut.caps[i])
      cut.caps[i] = std::make_unique<passes::CapGeometry>(cut.faces[i].cap);
    result.planes[i] = sectionVectors(otherPlanes(*cut.surface, cut.planes, i));
    const CapPaint paint = capPaint(shown, view, background, i);
    result.draws.push_back({.cap = *cut.caps[i],
                            .viewProjection = view.viewProjection(),
                            .pictureSize = view.size(),
                            .layer = area,
                            .slot = slot,
                            .otherSections = result.planes[i],
                            .colour = paint.colour,
                            .strokeColour = paint.strokeColour,
                            .stripes = paint.stripes,
                            .strokeHalfWidth = paint.strokeHalfWidth,
                            .depthPlane = paint.depthPlane});
  }
  return result;
}

}  // namespace sline::render
