// SPDX-License-Identifier: Apache-2.0
// Draws lines into their layer's ink as capsules with analytic anti-aliasing. Coverages join by
// maximum, so joints never darken twice. The same capsules, in the fill's colour and laid over it,
// soften the edges of fills that have lost their lines (Γ > 4).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "render/gpu/device.h"
#include "render/strokes/stroke.h"

namespace sline::render::passes {

/// Tells what strokes draw: ink, the soft edges of a fill along its contours, outlines that show
/// through what lies before them, where lines behind an outline stop, or where a fill ends that was
/// enlarged.
enum class InkKind { surfaceLines, contours, edges, hidden, halos, trims };
inline constexpr std::size_t inkKindCount = 6;

struct InkDraw {
  InkKind kind = InkKind::surfaceLines;  ///< that of all its strokes
  std::size_t first = 0;                 ///< index in the strokes last uploaded, farthest first
  std::size_t count = 0;
  PixelRect layer;  ///< as in SurfaceDraw
  PixelRect slot;
  int surfaceStep = 1;         ///< pixels of the layer for one of its surface's depth, each way
  glm::vec4 projection{0.0f};  ///< projection matrix [2][2], [3][2], [2][3], [3][3]
  float probe = 3.0f;  ///< px outside a contour at which its own mask makes it an inner contour
  glm::vec2 reach{1.0f, 4.0f};  ///< px outside a contour at which the surface has fallen away
  glm::vec4 paint{0.0f};        ///< a fill's colour and opacity, for edges
  glm::vec3 key{0.0f};     ///< the surfaces' key light in the camera's frame, for edges; 0: none
  float grain = 0.0f;      ///< of a pencil on paper, 0 … 1, for ink
  float grainSize = 1.0f;  ///< px
  float sheet = 0.0f;  ///< mm in front of a contour within which its own sheet may lie (see .glsl)
};

class InkPass {
 public:
  static Result<std::unique_ptr<InkPass>> create(gpu::Dialect dialect);
  void upload(std::span<const Stroke> strokes);
  /// Draws the ink coverage (or fills, for edges) and the layer's depth into the target. The
  /// structure's own surface, given by `surfaceDepth`, hides lines.
  void draw(gpu::Device& device, const gpu::Target& target, const gpu::Texture& surfaceDepth,
            const InkDraw& draw);

 private:
  InkPass();
  std::array<std::unique_ptr<gpu::Program>, inkKindCount> m_programs;  ///< by InkKind
  std::array<std::unique_ptr<gpu::Program>, inkKindCount> m_grained;   ///< null without grain
  gpu::Buffer m_segments;
  gpu::Geometry m_geometry;
};

}  // namespace sline::render::passes
