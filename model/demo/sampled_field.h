// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/demo/implicit.h"

namespace sline::model {

/// A field kept as samples on a grid and read as a cubic B-spline of them. Reading costs about 50
/// ns whatever the field was made of, and the spline, which does not pass through its samples,
/// rounds creases and facets finer than about `spacing`, so the surface has continuous curvature.
class SampledField {
 public:
  /// A field that need be right only within `reach` mm of a place.
  using LocalField = std::function<Field(const glm::vec3& place, float reach)>;

  /// Samples a field, signed distances in mm, every `spacing` mm within the box; the surface should
  /// keep two spacings away from the box.
  SampledField(const LocalField& near, const Box& box, float spacing);

  /// Near the surface about the signed distance; far away a lower bound of its magnitude.
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_box; }

 private:
  void sampleBlock(const Field& field, const glm::ivec3& first, int side);
  glm::vec3 middleOf(const glm::ivec3& first, int side) const;

  Box m_box;
  float m_spacing;
  glm::ivec3 m_size{0};
  std::vector<float> m_values;
};

}  // namespace sline::model
