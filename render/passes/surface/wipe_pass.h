// SPDX-License-Identifier: Apache-2.0
// Empties rectangles of a target: a layer's squares are scattered over its place in the atlas, and
// emptying all of that costs a software driver more than drawing the layer.
#pragma once

#include <memory>
#include <span>

#include "render/passes/target_rectangles.h"

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
  WipePass() = default;
  std::unique_ptr<gpu::Program> m_program;
  TargetRectangles m_rectangles{"wiped rectangles"};
};

}  // namespace sline::render::passes
