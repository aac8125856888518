// SPDX-License-Identifier: Apache-2.0
// Draws the shade of a structure as noise that is drawn out along the direction of its stronger
// curvature (Lawonn, Krone, Ertl, Preim, "Line Integral Convolution for Real-Time Illustration of
// Molecular Surface Shape and Salient Regions", EuroVis 2014).
//
// ▲ The paper draws noise out along the gradient of brightness; that turns with the camera and ends
// where a surface is evenly lit. The stronger curvature is what all hatching here follows. Noise
// belongs to the surface, so that it stays while the camera turns; its cells are as large as the
// picture's pen.
#pragma once

#include <memory>

#include "render/passes/hatching/hatching_pass.h"

namespace sline::render::passes {

struct NoiseLicDraw {
  /// As for HatchingDraw.
  const SurfaceDraw& surface;
  glm::vec3 middle{0.0f};      ///< of the noise, mm
  float cell = 1.0f;           ///< mm
  glm::vec3 light{0.0f};       ///< unit, towards the light, in the patient's frame
  float leastShade = 0.0f;     ///< from which on the structure is inked, 0 … 1
  float fromEye = 0.0f;        ///< the share of light that comes from the eye
  float entered = 1.0f;        ///< how much of the shade there is, 0 … 1
  float stride = 1.0f;         ///< px between steps
  float contourJump = 1.0f;    ///< as in HatchingDraw
  glm::vec4 projection{0.0f};  ///< as in HatchingDraw
};

class NoiseLicPass {
 public:
  /// The number of strides over which noise is drawn out each way.
  static constexpr int longest = 14;
  static Result<std::unique_ptr<NoiseLicPass>> create(gpu::Dialect dialect);
  /// Draws direction, noise and shade of the pixels that `surfaceDepths`, an atlas, shows.
  void drawFields(gpu::Device& device, const HatchingFields& to, const gpu::Texture& surfaceDepths,
                  const SurfaceView& view, const NoiseLicDraw& draw) const;
  /// Draws into the target the ink coverage, joined by maximum, and the layer's depth, which
  /// becomes the surface's where there is ink.
  void convolve(gpu::Device& device, const gpu::Target& target, const HatchingFields& from,
                const NoiseLicDraw& draw) const;

 private:
  NoiseLicPass();
  std::unique_ptr<gpu::Program> m_field;
  std::unique_ptr<gpu::Program> m_convolution;
  gpu::Geometry m_rectangle;
};

}  // namespace sline::render::passes
