// SPDX-License-Identifier: Apache-2.0
// Marks coarsely where structures are drawn, which labels should not cover.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/scene/scene.h"
#include "render/labels/seen/screen.h"
#include "render/labels/seen/shapes.h"

namespace sline::render {

struct ObstacleMask {
  int columns = 0;
  int rows = 0;
  glm::vec2 size{0.0f};             ///< of the whole picture, millimetres of the output
  std::vector<std::uint8_t> taken;  ///< one entry per cell, rows from the top
  std::optional<LabelBox> extent;   ///< of everything drawn in the picture, finer than cells

  std::size_t cellAt(int x, int y) const {
    return std::size_t(y) * std::size_t(columns) + std::size_t(x);
  }
  /// Returns the share of the box's area that is taken, 0 … 1.
  float share(const LabelBox& box) const;
};

/// Marks the visible structures' surfaces as sections leave them. Only some triangles of large
/// meshes are looked at, so that it takes about as long for any scene.
ObstacleMask obstaclesOf(const model::Scene& scene, const Screen& screen);

}  // namespace sline::render
