// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/tissue_pattern.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lines/hatching/clipping.h"
#include "render/lines/patterns/pattern_marks.h"

namespace sline::render {

namespace {

/// Cells of the grid that samples the face, along a spacing.
constexpr double cellsPerSpacing = 6.0;
/// The most cells of a face. A mark takes some 50, so this bounds the marks too.
constexpr double mostFaceCells = 2.5e6;
/// The distance that marks keep from the rim, in spacings.
constexpr double rimMargin = 0.12;

}  // namespace

double patternSpacing(double millimetresPerUnit) {
  const double wanted = leastPatternSpacing * millimetresPerUnit;
  return std::pow(patternStep, std::ceil(std::log2(wanted) / std::log2(patternStep)));
}

Hatching tissuePattern(const CutFace& face, std::span<const model::Plane> others,
                       TissuePatternRequest request) {
  std::optional<PlaneWindow> window = windowOf(face);
  if (!window || request.pattern == model::CutPattern::plain ||
      request.pattern == model::CutPattern::blank || !(request.spacing > 0.0))
    return {};
  if (request.window)
    window = PlaneWindow{glm::max(window->low, request.window->low),
                         glm::min(window->high, request.window->high)};
  const glm::dvec2 size = window->high - window->low;
  if (!(size.x > 0.0 && size.y > 0.0))
    return {};
  const auto cells = [&] {
    const glm::dvec2 across = size * (cellsPerSpacing / request.spacing) + 3.0;
    return across.x * across.y;
  };
  while (cells() > mostFaceCells)
    request.spacing *= 2.0;
  const FaceField field(face, *window, request.spacing / cellsPerSpacing);
  FacePen pen(face.plane, field, rimMargin * request.spacing);
  const model::PlaneAxes axes = model::axesOf(face.plane);
  const glm::dvec3 fibres(request.fibres);
  drawPattern(
      request.pattern,
      {.spacing = request.spacing, .fibres = {glm::dot(axes.u, fibres), glm::dot(axes.v, fibres)}},
      pen);
  Hatching drawn = pen.take();
  clip(drawn, others);
  return drawn;
}

}  // namespace sline::render
