// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/sculpting/implicit.h"

namespace sline::model {

/// Keeps a field as samples on a grid and reads it as a cubic B-spline of them. Reading costs about
/// 50 ns whatever the field was made of. The samples are smoothed as clay is by a thumb: creases,
/// facets and lumps finer than about `smoothing` vanish, larger shapes stay, curvature is
/// continuous.
class SampledField {
 public:
  /// Returns a field that need only be right within `reach` mm of a place.
  using LocalField = std::function<Field(const glm::vec3& place, float reach)>;

  /// All lengths are in mm; smoothing is the standard deviation of a Gaussian, at least 0.6
  /// spacings, which reading through the spline causes anyway.
  struct Fineness {
    float spacing;
    float smoothing;
    float depth = 0.0f;  ///< distances are exact this much farther from the surface
  };

  /// Samples a field of signed distances in mm within the box; the surface should keep two spacings
  /// and twice the smoothing away from the box.
  SampledField(const LocalField& near, const Box& box, Fineness fineness);

  /// Returns about the signed distance near the surface, and a lower bound of its magnitude far
  /// away.
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_box; }

 private:
  void sampleBlock(const Field& field, const glm::ivec3& first, int side);
  glm::vec3 middleOf(const glm::ivec3& first, int side) const;
  void smoothOnce(std::ptrdiff_t stride);

  Box m_box;
  float m_spacing;
  float m_band;  ///< mm from the surface within which samples are exact
  glm::ivec3 m_size{0};
  std::vector<float> m_values;
};

}  // namespace sline::model
