// SPDX-License-Identifier: Apache-2.0
// Computes what a stroke of a brush paints on a surface. The brush is a disc in the picture and
// paints what one sees of the surface within it, as brushes of programs for sculpture do: other
// structures are no obstacle, the surface itself is. No window.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "model/base/units.h"
#include "model/geometry/paint.h"
#include "widgets/brush/brush_sight.h"

namespace sline::widgets {

struct Brush {
  float radius = 40.0f;   ///< pixels
  float softness = 0.5f;  ///< 0: alike up to the rim, 1: weaker from the middle on
  float strength = 1.0f;  ///< how much of the way a stroke goes in its middle, 0 … 1
  bool erases = false;
  bool operator==(const Brush&) const = default;
};
inline constexpr Limits<float> brushRadii{4.0f, 300.0f};

/// Returns how strongly the brush works at that distance from its middle, 0 … its strength.
float brushWeight(const Brush& brush, float pixels);

class BrushStroke {
 public:
  /// `before` is what is painted on the mesh; null: nothing.
  BrushStroke(BrushSightPtr sight, const model::PaintPtr& before, const Brush& brush);

  /// Moves the brush from one pixel straight to another; tells whether that has changed the paint.
  /// However often a stroke passes a place, it works there once, as strongly as where it came
  /// nearest.
  bool move(const glm::vec2& from, const glm::vec2& to);
  /// Returns what is painted by now.
  model::PaintPtr paint() const { return std::make_shared<const model::Paint>(m_paint); }

 private:
  bool cover(std::uint32_t vertex, float weight);

  BrushSightPtr m_sight;
  Brush m_brush;
  std::vector<float> m_covered;  ///< how strongly the stroke has worked at each vertex
  model::Paint m_before;
  model::Paint m_paint;
};

}  // namespace sline::widgets
