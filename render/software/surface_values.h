// SPDX-License-Identifier: Apache-2.0
// Holds what the shading of a fill needs to know of samples, and shades them (METHOD §7, §10).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/drawn/fill_shading.h"
#include "render/drawn/surface_fill.h"
#include "render/software/layer_pixels.h"

namespace sline::render {

/// Names what a fill's shading needs to know of a place.
enum SampleValue : std::size_t {
  normalX,
  normalY,
  normalZ,
  gradient,
  gammaOffset,
  sampleValueCount
};

/// Says of each value whether it is needed.
using NeededValues = std::array<bool, sampleValueCount>;
NeededValues neededValues(const SurfaceFill& fill);

/// Holds what is seen of one surface at all samples of an area, in rows from the bottom: enough to
/// shade it with any fill that needs no other values.
struct SurfaceValues {
  std::vector<float> depths;  ///< 1: nothing is there; none: nothing is known
  std::array<std::vector<float>, sampleValueCount> values;  ///< none: not known

  bool serves(const NeededValues& needed) const;
};

/// Names samples of an area that lie side by side.
struct SampleSpan {
  int row;
  int column;
  int end;  ///< the column behind the last
};

/// Points at the values of a span's first sample; those that are not needed may be null.
using ValueSpans = std::array<const float*, sampleValueCount>;

/// Shades a surface's samples as they are seen in a view.
class SampleShading {
 public:
  /// Takes the unit direction towards a key light in the patient's frame; 0: there is none.
  SampleShading(const SurfaceFill& fill, const glm::vec3& key);

  const SurfaceFill& fill() const { return m_fill; }
  const NeededValues& needed() const { return m_needed; }
  bool shaded() const { return m_fill.kind == SurfaceFill::Kind::phong; }
  /// Finds the span's colours, packed as pixels hold them.
  void shade(const PictureView& view, const SampleArea& samples, const SampleSpan& span,
             const ValueSpans& values, std::uint32_t* colours) const;

 private:
  SurfaceFill m_fill;
  NeededValues m_needed;
  FillShading m_shading;
};

}  // namespace sline::render
