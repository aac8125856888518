// SPDX-License-Identifier: Apache-2.0
// Lays pixels that the processor drew over those of a target.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>

#include "render/passes/target_rectangles.h"

namespace sline::render::passes {

struct Overlay {
  const gpu::Texture& colours;            ///< premultiplied
  glm::ivec2 corner{0};                   ///< of its first pixel in the target
  std::span<const PixelRect> rectangles;  ///< what is laid over, in pixels of the target
};

class OverlayPass {
 public:
  static Result<std::unique_ptr<OverlayPass>> create(gpu::Dialect dialect);
  void draw(gpu::Device& device, const gpu::Target& target, const Overlay& overlay);

 private:
  OverlayPass() = default;
  std::unique_ptr<gpu::Program> m_program;
  TargetRectangles m_rectangles{"overlaid rectangles"};
};

}  // namespace sline::render::passes
