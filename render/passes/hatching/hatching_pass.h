// SPDX-License-Identifier: Apache-2.0
// Draws hatching as S §3.4 prints it, one structure at a time: smart seeds of one scale, a line
// search that looks at single pixels, strokes in grey. It is the yardstick for the picture's own
// hatching, with the flaws that S §5 names.
#pragma once

#include <memory>

#include "render/passes/surface_draw.h"

namespace sline::render::passes {

struct HatchingDraw {
  /// As for the surface pass, which must have drawn the same before; of the fill, only `twoSided`
  /// and `filigree` count. The surface needs its shape.
  const SurfaceDraw& surface;
  glm::vec3 gridCorner{0.0f};  ///< mm
  float cell = 1.0f;           ///< c_s, mm
  float feature = 1.0f;        ///< F, mm
  float threshold = 0.0f;      ///< θ_c, rad
  float opacity = 1.0f;        ///< the share of it that remains at Γ > 4
  float stride = 1.0f;         ///< px between steps of the search
  float contourJump = 1.0f;    ///< the change of depth between steps, in mm, that marks a contour
  glm::vec4 projection{0.0f};  ///< projection matrix [2][2], [3][2], [2][3], [3][3]
};

/// Holds what the search reads: `fields` are rgba32i, `depths` depth32f, both at least as large as
/// the layer; the target draws into both.
struct HatchingFields {
  const gpu::Texture& fields;
  const gpu::Texture& depths;
  const gpu::Target& target;
};

/// Sets what the programs that draw a surface's fields into its slot have in common.
void setSlot(const gpu::Program& program, const gpu::Texture& surfaceDepths,
             const SurfaceView& view, const SurfaceDraw& surface);
/// Draws the fields of the surface's visible part with a program that is set.
void drawSlot(gpu::Device& device, const HatchingFields& to, const gpu::Program& program,
              const SurfaceDraw& surface);

/// Says how each pixel of a slot walks along the directions of its fields.
struct SlotWalk {
  const gpu::Program& program;
  const gpu::Geometry& rectangle;
  PixelRect slot;
  glm::vec4 projection{0.0f};  ///< as in HatchingDraw
  int longest = 1;             ///< steps each way
  float stride = 1.0f;         ///< px between steps
  float contourJump = 1.0f;    ///< as in HatchingDraw
};
/// Lets all pixels of the slot walk. The target gets the ink coverage, joined by maximum, and the
/// layer's depth.
void drawWalk(gpu::Device& device, const gpu::Target& target, const HatchingFields& from,
              const SlotWalk& walk);

class HatchingPass {
 public:
  /// The number of strides that the search goes each way.
  static constexpr int longestSearch = 50;
  static Result<std::unique_ptr<HatchingPass>> create(gpu::Dialect dialect);
  /// Draws the light gradient, seeds and opacity of the pixels that `surfaceDepths`, an atlas,
  /// shows.
  void drawFields(gpu::Device& device, const HatchingFields& to, const gpu::Texture& surfaceDepths,
                  const SurfaceView& view, const HatchingDraw& draw) const;
  /// Draws into the target the ink coverage, joined by maximum, and the layer's depth, which
  /// becomes the surface's where there is hatching.
  void search(gpu::Device& device, const gpu::Target& target, const HatchingFields& from,
              const HatchingDraw& draw) const;

 private:
  HatchingPass();
  std::unique_ptr<gpu::Program> m_field;
  std::unique_ptr<gpu::Program> m_search;
  gpu::Geometry m_rectangle;
};

}  // namespace sline::render::passes
