// SPDX-License-Identifier: Apache-2.0
#include "render/software/surface_values.h"

#include <algorithm>
#include <glm/vec2.hpp>

namespace sline::render {

NeededValues neededValues(const SurfaceFill& fill) {
  if (fill.kind != SurfaceFill::Kind::phong)
    return {};
  return {true, true, true, fill.byForm, fill.gammaOffsets != nullptr};
}

bool SurfaceValues::serves(const NeededValues& needed) const {
  bool known = !depths.empty();
  for (std::size_t value = 0; value < sampleValueCount; ++value)
    known = known && (!needed[value] || !values[value].empty());
  return known;
}

SampleShading::SampleShading(const SurfaceFill& fill, const glm::vec3& key)
    : m_fill(fill), m_needed(neededValues(fill)), m_shading(fill, key) {}

void SampleShading::shade(const PictureView& view, const SampleArea& samples,
                          const SampleSpan& span, const ValueSpans& values,
                          std::uint32_t* colours) const {
  if (!shaded()) {
    std::fill(colours, colours + (span.end - span.column), packedColour(m_fill.wash));
    return;
  }
  const SampleGrid& grid = samples.grid;
  const auto middle = [&](int x) {
    return glm::vec2(grid.corner) +
           float(grid.step) * (glm::vec2(float(x), float(samples.area.y + span.row)) + 0.5f);
  };
  const glm::vec3 first = view.towardsEye(middle(0));
  m_shading.shade({.normal = {values[normalX], values[normalY], values[normalZ]},
                   .gradient = values[gradient],
                   .gammaOffset = values[gammaOffset],
                   .towardsEye = first,
                   .step = view.towardsEye(middle(1)) - first,
                   .column = samples.area.x + span.column,
                   .count = std::size_t(span.end - span.column)},
                  colours);
}

}  // namespace sline::render
