// SPDX-License-Identifier: Apache-2.0
// Draws one structure into its layer: depth, and its fill where it has one (METHOD §7).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "render/gpu/device.h"
#include "render/passes/surface_geometry.h"

namespace sline::render::passes {

/// The camera of the whole picture.
struct SurfaceView {
  glm::mat4 viewProjection{1.0f};
  glm::vec4 eye{0.0f};  ///< position and 1, or for a parallel projection direction and 0
  glm::vec2 pictureSize{1.0f};
  glm::vec3 key{0.0f};  ///< unit, towards a key light besides the headlight; 0: there is none
};

/// How the surface's pixels look.
struct SurfaceFill {
  enum class Kind { depthOnly, flat, phong };
  Kind kind = Kind::depthOnly;
  glm::vec4 wash{0.0f};  ///< premultiplied, under the shading; all there is to a flat fill
  glm::vec3 colour{1.0f};
  float shading = 0.0f;   ///< T_P
  float complete = 0.0f;  ///< clamp01(Γ − 4): mixes the opacity with 1
  float opacity = 1.0f;   ///< the style's
  float filigree = 1.0f;  ///< F_c in mm
  /// 1: a thin fill shows the colour itself, and shadows deepen as it closes; they would grey white
  /// paper. 0: shadows from the start; on a dark ground colour would lighten them first.
  float glaze = 0.0f;
  bool twoSided = false;  ///< normals turn towards the eye
};

struct SurfaceDraw {
  SurfaceGeometry& surface;
  std::span<const gpu::DrawRange> ranges;
  std::span<const std::uint32_t> visible;  ///< where not empty, only these triangles are drawn
  gpu::Rect layer;                         ///< in picture pixels, y upwards
  gpu::Rect slot;                          ///< the layer's place in the target, of the same size
  SurfaceFill fill;
  std::span<const glm::vec4> sections;  ///< as in sections.glsl; at most 8
};

class SurfacePass {
 public:
  static Result<std::unique_ptr<SurfacePass>> create(gpu::Dialect dialect);
  void draw(gpu::Device& device, const gpu::Target& target, const SurfaceView& view,
            const SurfaceDraw& draw) const;

 private:
  SurfacePass() = default;
  std::unique_ptr<gpu::Program> m_flat;
  std::unique_ptr<gpu::Program> m_phong;
  // Their own programs, so that what is not cut pays nothing: `discard` costs early depth tests.
  std::unique_ptr<gpu::Program> m_flatCut;
  std::unique_ptr<gpu::Program> m_phongCut;
};

}  // namespace sline::render::passes
