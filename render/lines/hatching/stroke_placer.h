// SPDX-License-Identifier: Apache-2.0
// Lays the strokes of one cube of a surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

/// The distance of marks along a stroke, in distances between strokes.
inline constexpr float markStep = 0.35f;

/// Lays one cube's strokes.
class StrokeLayout::Placer {
 public:
  Placer(const StrokeLayout& layout, int level, StrokeSpacing& taken);

  void place(const PlacedSeed& seed);
  LaidTile take();

 private:
  struct Own {
    StrokeSpacing::Mark mark;
    float place;  ///< mm from the seed along the stroke, negative one way
  };

  class Arm;

  bool meetsItself(const StrokeSpacing::Mark& mark, float place) const;
  LaidPoint packed(const SurfacePoint& at) const;
  void keep(const PlacedSeed& seed);
  void describe(LaidStroke& stroke);

  const StrokeLayout& m_layout;
  float m_distance;
  float m_half;  ///< mm, the longest half of a stroke
  float m_step;
  StrokeSpacing& m_taken;
  std::vector<SurfacePoint> m_points;
  std::vector<Own> m_marks;
  std::uint32_t m_seedPoint = 0;
  std::uint32_t m_rows = 0;  ///< how long those of the tile's strokes are together
  std::vector<std::array<float, 6>> m_bendings;
  std::vector<StrokeSpacing::Mark> m_described;  ///< the points of the stroke in work, evened
  LaidTile m_tile;
};

}  // namespace sline::render
