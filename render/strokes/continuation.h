// SPDX-License-Identifier: Apache-2.0
// Tells where one line of a drawing goes on in another (METHOD §11.1), the same before and after
// what hides lines has cut them.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sline::render {

/// The widest gap, in λ, for which a pen would not lift.
inline constexpr float widestGap = 2.0f;

/// Tells whether a line that ends with direction `a` goes on in one that ends with direction `b`,
/// `way` further; directions are unit and point away from their lines. They may turn by 45°, over a
/// gap by 60°, over one for which a pen would lift by 30°. `unit` is λ in the unit of `way`,
/// `widest` the gap in λ.
inline bool goesOnIn(const glm::vec2& a, const glm::vec2& b, const glm::vec2& way, float unit,
                     float widest = widestGap) {
  constexpr float straight = 0.7071f;
  constexpr float samePlace = 0.5f;  // λ
  const float distance = glm::length(way);
  const float leading = distance > widestGap * unit ? 0.866f : 0.5f;
  return distance <= widest * unit && glm::dot(a, b) <= -straight &&
         (distance <= samePlace * unit || glm::dot(way, a) >= leading * distance);
}

}  // namespace sline::render
