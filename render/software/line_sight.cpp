// SPDX-License-Identifier: Apache-2.0
#include "render/software/line_sight.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/sight/rules.h"

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
    if (place.depth - tolerance <= pixels.surfaceDepthAt(place.at + to))
      return true;
  }
  return false;
}

/// Returns at which of the looks a contour is in sight; 4 where it is hidden. Within a step its own
/// surface falls away from the eye or ends, while a hidden contour has something nearer on both
/// sides. Where a surface is seen along its length, its triangles' outline may lie a few pixels
/// outside the line: there, and only if the same sheet hides the line, a wider step counts.
int contourLook(const LayerPixels& pixels, const Place& place, const glm::vec2& reach,
                float tolerance, float sheet) {
  const std::array<float, 4> outside{0.0f, reach.x, 0.5f * (reach.x + reach.y), reach.y};
  float here = 0.0f;
  for (int k = 0; k < 4; ++k) {
    const float surface = pixels.surfaceDepthAt(place.at + outside[std::size_t(k)] * place.outward);
    if (place.depth - tolerance <= surface)
      return k;
    here = k == 0 ? surface : here;
    if (k == 1 && place.depth - sheet > here)
      break;
  }
  return 4;
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
    const int look = contourLook(pixels, place, draw.reach, tolerance, sheet);
    if (look == 4)
      continue;
    sight |= 1u << i;
    const float beyond = draw.probe + (look > 1 ? draw.reach.y : 0.0f);
    if (pixels.surfaceDepthAt(place.at + beyond * place.outward) < 1.0f)
      sight |= 0x10000u << i;
  }
  return sight;
}

}  // namespace sline::render
