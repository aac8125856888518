// SPDX-License-Identifier: Apache-2.0
// Decides where strokes of hatching run: a line field on the surface that no view changes.
//
// ▲ S §3.4 follows the light gradient k = S·w (METHOD §3), which turns with the eye, so that with
// every frame strokes swing about their seeds. Averaged over all views, k·kᵀ has the principal
// directions of S as its axes. Strokes that run along the stronger axis follow k from wherever the
// surface is seen best, stay on the surface for good, and are what engravers draw: across a hollow
// and around a limb (A. Hertzmann and D. Zorin, "Illustrating Smooth Surfaces", 2000).
#pragma once

#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/surface.h"

namespace sline::render {

/// Holds a unit tangent for every vertex, of either sign, to a thousandth. Where the curvature
/// gives no direction (on a sphere, in a plane) the neighbours do.
class StrokeDirections {
 public:
  explicit StrokeDirections(const model::Surface& surface);
  glm::vec3 operator[](std::size_t vertex) const {
    return glm::vec3(glm::unpackSnorm3x10_1x2(m_packed[vertex]));
  }

 private:
  std::vector<std::uint32_t> m_packed;
};

}  // namespace sline::render
