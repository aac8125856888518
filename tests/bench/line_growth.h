// SPDX-License-Identifier: Apache-2.0
// Measures how what contours and suggestive contours cost grows with a surface's triangles, beside
// two yardsticks of VTK from the same cameras: its silhouette filter and its Phong.
#pragma once

#include <glm/vec2.hpp>
#include <iosfwd>
#include <span>

#include "model/base/result.h"
#include "model/camera/camera.h"
#include "model/scene/scene.h"

namespace sline::bench {

struct LineGrowthRun {
  const model::Scene& scene;
  std::span<const model::Camera> cameras;
  int subdivisions = 0;  ///< Loop's, each of which makes four triangles of one
  glm::ivec2 size;       ///< of Phong's pictures, in pixels
};

/// Prints a row for the surfaces together as they are and one after each subdivision: preparation
/// and what it keeps, lines, yardsticks, ratios; and the exponents by which these grow. Times are
/// medians over the cameras.
Status measureLineGrowth(const LineGrowthRun& run, std::ostream& out);

}  // namespace sline::bench
