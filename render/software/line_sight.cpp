// SPDX-License-Identifier: Apache-2.0
#include "render/software/line_sight.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/sight/contour_look.h"

namespace sline::render {

namespace {

/// A place of a stroke that is looked for.
struct Place {
  glm::vec2 at;
  glm::vec2 outward;
  float depth;
};

/// A line on the surface is in sight if one of the four texels around it is no nearer.
bool surfaceLineInSight(const LayerPixels& pixels, const Place& place, float tolerance) {
  const float step = float(pixels.step());
  for (int k = 0; k < 4; ++k) {
    const glm::vec2 to = (glm::vec2(float(k & 1), float(k >> 1)) - 0.5f) * step;
    if (rule::leavesInSight(pixels.surfaceDepthAt(place.at + to), place.depth, tolerance))
      return true;
  }
  return false;
}

}  // namespace

std::uint32_t lineSight(const LayerPixels& pixels, const InkDraw& draw, const Stroke& stroke,
                        int steps) {
  const float middle = 0.5f * (stroke.depthA + stroke.depthB);
  const float tolerance = rule::depthLift(middle, stroke.tolerance, draw.projection);
  const bool contours = draw.kind != InkKind::surfaceLines;
  const float sheet = contours ? rule::depthLift(middle, draw.sheet, draw.projection) : 0.0f;
  std::uint32_t sight = 0;
  for (int i = 0; i <= steps; ++i) {
    const float t = float(i) / float(std::max(steps, 1));
    Place place{.at = glm::mix(stroke.a, stroke.b, t),
                .outward = glm::vec2(0.0f),
                .depth = glm::mix(stroke.depthA, stroke.depthB, t)};
    if (!contours) {
      if (surfaceLineInSight(pixels, place, tolerance))
        sight |= 1u << i;
      continue;
    }
    place.outward =
        glm::normalize(glm::mix(stroke.outwardA, stroke.outwardB, t) + glm::vec2(1e-6f, 0.0f));
    const std::optional<int> look = contourLook(
        {place.depth, tolerance, sheet, draw.reach},
        [&](float outside) { return pixels.surfaceDepthAt(place.at + outside * place.outward); });
    if (!look)
      continue;
    sight |= 1u << i;
    const float beyond = rule::probeOutside(*look, draw.probe, draw.reach);
    if (pixels.surfaceDepthAt(place.at + beyond * place.outward) < 1.0f)
      sight |= 0x10000u << i;
  }
  return sight;
}

}  // namespace sline::render
