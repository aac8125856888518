// SPDX-License-Identifier: Apache-2.0
// Empties rectangles of a target: a layer's squares are scattered over its place in the atlas, and
// emptying all of that costs a software driver more than drawing the layer.
#pragma once

#include <memory>
#include <span>

#include "render/passes/surface_draw.h"

namespace sline::render::passes {

struct Wipe {
  std::span<const PixelRect> rectangles;
  bool colour = false;  ///< becomes transparent
  bool depth = false;   ///< becomes 1
};

class WipePass {
 public:
  static Result<std::unique_ptr<WipePass>> create(gpu::Dialect dialect);
  void draw(gpu::Device& device, const gpu::Target& target, const Wipe& wipe);

 private:
  WipePass();
  std::unique_ptr<gpu::Program> m_program;
  gpu::Buffer m_rectangles;
  gpu::Geometry m_geometry;
};

}  // namespace sline::render::passes
