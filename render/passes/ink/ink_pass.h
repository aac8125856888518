// SPDX-License-Identifier: Apache-2.0
// Draws lines into their layer's ink as capsules with analytic anti-aliasing. Coverages join by
// maximum, so joints never darken twice. The same capsules, in the fill's colour and laid over it,
// soften the edges of fills that have lost their lines (Γ > 4). What the structure's own surface
// hides is found before, once for all pixels across a stroke.
#pragma once

#include <array>
#include <memory>

#include "render/gpu/device.h"
#include "render/gpu/draw_queue.h"
#include "render/passes/ink/ink_batch.h"

namespace sline::render::passes {

/// Where strokes go: fills with their layers' depth, for edges, and ink with it, for all others.
struct InkTargets {
  const gpu::Target& fills;
  const gpu::Target& ink;
};

/// The layers' surfaces as they were drawn.
struct InkSurfaces {
  const gpu::Texture& depths;              ///< these hide lines
  const gpu::Texture* enlarged = nullptr;  ///< the fills, where they are enlarged
};

class InkPass {
 public:
  static Result<std::unique_ptr<InkPass>> create(gpu::Dialect dialect);
  /// Draws the ink coverage (or fills, for edges) and the layers' depths into the targets, one draw
  /// after the other. Drivers work best if all edges come first.
  Status draw(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
              std::span<const InkDraw> draws);

 private:
  InkPass();
  Status drawBatch(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
                   gpu::DrawQueue& queue);
  Status makeRoom(int strokeRows, int lookRows);
  void findSights(gpu::Device& device, const gpu::Texture& surfaceDepth, gpu::DrawQueue& queue);
  void drawRun(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
               const InkBatch::Run& run);
  void fillUp(gpu::Device& device, const InkTargets& targets, const InkSurfaces& surfaces,
              const InkBatch::Run& run);

  std::array<std::unique_ptr<gpu::Program>, inkKindCount> m_programs;  ///< by InkKind
  std::array<std::unique_ptr<gpu::Program>, inkKindCount> m_grained;   ///< null without grain
  std::unique_ptr<gpu::Program> m_fillUp;                              ///< comes before trims
  std::unique_ptr<gpu::Program> m_sight;
  InkBatch m_batch;
  gpu::Buffer m_segments;
  gpu::Geometry m_geometry;
  gpu::Geometry m_rectangle;
  std::unique_ptr<gpu::Texture> m_strokes;
  std::unique_ptr<gpu::Texture> m_looks;
  std::unique_ptr<gpu::Texture> m_sights;
  std::unique_ptr<gpu::Target> m_sightTarget;
};

}  // namespace sline::render::passes
