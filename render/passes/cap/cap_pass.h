// SPDX-License-Identifier: Apache-2.0
// Draws the faces that section planes leave in solids (METHOD §7): flat, with optional strokes.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "render/gpu/device.h"

namespace sline::render::passes {

/// The number of planes that `sections.glsl` knows.
inline constexpr std::size_t sectionSlots = 8;

/// Holds triangles of three points each.
class CapGeometry {
 public:
  explicit CapGeometry(std::span<const glm::vec3> points);
  const gpu::Geometry& geometry() const { return m_geometry; }
  std::uint32_t pointCount() const { return m_pointCount; }

 private:
  gpu::Buffer m_points;
  gpu::Geometry m_geometry;
  std::uint32_t m_pointCount;
};

struct CapDraw {
  const CapGeometry& cap;
  glm::mat4 viewProjection{1.0f};  ///< of the whole picture
  glm::vec2 pictureSize{1.0f};
  PixelRect layer;  ///< as in SurfaceDraw
  PixelRect slot;
  std::span<const glm::vec4> otherSections;  ///< as in sections.glsl: they cut the face itself
  glm::vec4 colour{0.0f};                    ///< premultiplied
  glm::vec4 strokeColour{0.0f};              ///< premultiplied; alpha 0: no strokes
  glm::vec4 stripes{0.0f};  ///< the number of a point's stripe, and the share of the odd stripes
  float strokeHalfWidth = 0.5f;  ///< px
  glm::vec3 depthPlane{0.0f};    ///< window depth, linear in px from the picture's middle
};

class CapPass {
 public:
  static Result<std::unique_ptr<CapPass>> create(gpu::Dialect dialect);
  /// Draws fills and the surface's own depth into the target, as SurfacePass does.
  void draw(gpu::Device& device, const gpu::Target& target, const CapDraw& draw) const;

 private:
  CapPass() = default;
  std::unique_ptr<gpu::Program> m_program;
};

}  // namespace sline::render::passes
