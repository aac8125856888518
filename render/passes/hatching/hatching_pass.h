// SPDX-License-Identifier: Apache-2.0
// Hatching as S §3.4 prints it, one structure at a time: smart seeds of one scale, a line search
// that looks at single pixels, strokes in grey. It is the yardstick that the picture's own hatching
// is measured by, with the flaws that S §5 names.
#pragma once

#include <memory>

#include "render/passes/surface_draw.h"

namespace sline::render::passes {

struct HatchingDraw {
  /// As for the surface pass, which must have drawn the same before; of the fill, `twoSided` and
  /// `filigree` count. The surface needs its shape.
  const SurfaceDraw& surface;
  glm::vec3 gridCorner{0.0f};  ///< mm
  float cell = 1.0f;           ///< c_s, mm
  float feature = 1.0f;        ///< F, mm
  float threshold = 0.0f;      ///< θ_c, rad
  float opacity = 1.0f;        ///< what Γ > 4 leaves of it
  float stride = 1.0f;         ///< px from step to step of the search
  float contourJump = 1.0f;    ///< mm by which depth changes at a contour from step to step
  glm::vec4 projection{0.0f};  ///< projection matrix [2][2], [3][2], [2][3], [3][3]
};

/// What the search reads: `fields` are rgba32i, `depths` depth32f, both at least as large as the
/// layer; the target draws into both.
struct HatchingFields {
  const gpu::Texture& fields;
  const gpu::Texture& depths;
  const gpu::Target& target;
};

class HatchingPass {
 public:
  /// How many strides the search goes each way.
  static constexpr int longestSearch = 50;
  static Result<std::unique_ptr<HatchingPass>> create(gpu::Dialect dialect);
  /// Light gradient, seeds and opacity of the pixels that `surfaceDepths`, an atlas, shows.
  void drawFields(gpu::Device& device, const HatchingFields& to, const gpu::Texture& surfaceDepths,
                  const SurfaceView& view, const HatchingDraw& draw) const;
  /// Target: ink coverage, joined by maximum, and the layer's depth, which becomes the surface's
  /// where there is hatching.
  void search(gpu::Device& device, const gpu::Target& target, const HatchingFields& from,
              const HatchingDraw& draw) const;

 private:
  HatchingPass();
  std::unique_ptr<gpu::Program> m_field;
  std::unique_ptr<gpu::Program> m_search;
  gpu::Geometry m_rectangle;
};

}  // namespace sline::render::passes
