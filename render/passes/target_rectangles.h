// SPDX-License-Identifier: Apache-2.0
// Draws rectangles of a target: layers and lines touch only parts of one, and drawing all of it
// costs a software driver more than those.
#pragma once

#include <span>
#include <string_view>

#include "render/gpu/device.h"

namespace sline::render::passes {

/// Hands rectangles to programs with the vertex shader wipe.vert.glsl, whose uniform `targetSize`
/// it sets.
class TargetRectangles {
 public:
  explicit TargetRectangles(std::string_view name);
  /// Draws in the rectangles, in pixels of the target. The state's viewport becomes all of it.
  void draw(gpu::Device& device, const gpu::Target& target, gpu::Program& program,
            std::span<const PixelRect> rectangles, gpu::DrawState state);

 private:
  gpu::Buffer m_rectangles;
  gpu::Geometry m_geometry;
};

}  // namespace sline::render::passes
