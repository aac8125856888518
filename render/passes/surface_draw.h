// SPDX-License-Identifier: Apache-2.0
// Describes one structure's surface as passes draw it, and the camera that it is seen with.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "render/drawn/surface_fill.h"
#include "render/gpu/device.h"
#include "render/passes/surface_geometry.h"

namespace sline::render::passes {

/// Describes the camera of the whole picture.
struct SurfaceView {
  glm::mat4 viewProjection{1.0f};
  glm::vec4 eye{0.0f};  ///< position and 1, or for a parallel projection direction and 0
  glm::vec2 pictureSize{1.0f};
  glm::vec3 key{0.0f};  ///< unit, towards a key light besides the headlight; 0: there is none
};

struct SurfaceDraw {
  SurfaceGeometry& surface;
  std::span<const std::uint32_t> triangles;  ///< those to draw, three vertices each
  bool whole = false;                        ///< instead: all that the surface keeps, ...
  bool cullsBack = false;                    ///< ... but for those that turn away from the eye
  PixelRect layer;                           ///< in picture pixels, y upwards
  PixelRect slot;  ///< the layer's place in the target; smaller by a whole factor for a step
  SurfaceFill fill;
  std::span<const glm::vec4> sections;  ///< as in sections.glsl; at most 8
};

}  // namespace sline::render::passes
