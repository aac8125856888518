// SPDX-License-Identifier: Apache-2.0
// Draws one opaque Phong pass as any viewer does, every triangle of it: the yardstick of the
// benchmark.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "render/gpu/device.h"
#include "render/passes/surface_geometry.h"

namespace sline::render::passes {

class PlainPhongPass {
 public:
  static Result<std::unique_ptr<PlainPhongPass>> create(gpu::Dialect dialect);

  struct View {
    glm::mat4 viewProjection{1.0f};
    glm::vec4 eye{0.0f};  ///< as in SurfaceView
  };
  /// Fills the whole target, of which the depth must be cleared once before the first surface.
  void draw(gpu::Device& device, const gpu::Target& target, const View& view,
            const SurfaceGeometry& surface, const glm::vec3& colour) const;

 private:
  PlainPhongPass() = default;
  std::unique_ptr<gpu::Program> m_program;
};

}  // namespace sline::render::passes
