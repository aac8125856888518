// SPDX-License-Identifier: Apache-2.0
// Enlarges fills and depths of surfaces that were drawn coarser than the picture's lines.
#pragma once

#include <memory>
#include <span>

#include "render/passes/target_rectangles.h"

namespace sline::render::passes {

struct Enlargement {
  const gpu::Texture& colours;            ///< premultiplied
  const gpu::Texture& depths;             ///< 1 where a layer has nothing
  int step = 2;                           ///< pixels of the target for one of these, each way
  std::span<const PixelRect> rectangles;  ///< of the target
};

class EnlargePass {
 public:
  static Result<std::unique_ptr<EnlargePass>> create(gpu::Dialect dialect);
  /// Replaces colour and depth of the target in the rectangles.
  void draw(gpu::Device& device, const gpu::Target& target, const Enlargement& enlargement);

 private:
  EnlargePass() = default;
  std::unique_ptr<gpu::Program> m_program;
  TargetRectangles m_rectangles{"enlarged rectangles"};
};

}  // namespace sline::render::passes
