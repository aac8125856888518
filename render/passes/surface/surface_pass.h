// SPDX-License-Identifier: Apache-2.0
// Draws one structure into its layer: depth, and its fill where it has one (METHOD §7).
#pragma once

#include <memory>

#include "render/passes/surface_draw.h"

namespace sline::render::passes {

class SurfacePass {
 public:
  static Result<std::unique_ptr<SurfacePass>> create(gpu::Dialect dialect);
  void draw(gpu::Device& device, const gpu::Target& target, const SurfaceView& view,
            const SurfaceDraw& draw) const;

 private:
  SurfacePass() = default;
  std::unique_ptr<gpu::Program> m_flat;
  std::unique_ptr<gpu::Program> m_phong;
  // Separate programs, so that uncut surfaces pay nothing: `discard` costs early depth tests.
  std::unique_ptr<gpu::Program> m_flatCut;
  std::unique_ptr<gpu::Program> m_phongCut;
  std::unique_ptr<gpu::Program> m_varying;
  std::unique_ptr<gpu::Program> m_varyingCut;
  FillStages m_stages{};  ///< of Γ, for those two
};

}  // namespace sline::render::passes
