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

namespace sline::render::passes {

/// A piece of a line in pixels of the whole picture, y upwards.
struct InkSegment {
  glm::vec2 a{0.0f};
  glm::vec2 b{0.0f};
  float depthA = 0.0f;  ///< window depth, 0 … 1
  float depthB = 0.0f;
  float tolerance = 0.0f;  ///< mm that its own surface may lie before it
  float contour = 0.0f;    ///< 0: a line on the surface, its stroke is centred; else a contour, its
                           ///< stroke lies outside of the line, and 1 … 2: 1 + the share of it
                           ///< that is left within the surface's own mask. Negative: a stroke of
                           ///< hatching, a line on the surface with a softer or harder edge: over
                           ///< that many pixels
  glm::vec2 outwardA{0.0f};
  glm::vec2 outwardB{0.0f};
  float halfWidthA = 1.0f;  ///< px, at least 0.5
  float halfWidthB = 1.0f;
  float opacityA = 1.0f;
  float opacityB = 1.0f;
};

/// The kinds of segments, by `InkSegment::contour` and by what they draw: ink, or the soft edges of
/// a fill along its contours.
enum class InkKind { surfaceLines, contours, edges };

struct InkDraw {
  InkKind kind = InkKind::surfaceLines;  ///< of all its segments
  std::size_t first = 0;                 ///< in the segments last uploaded, farthest first
  std::size_t count = 0;
  gpu::Rect layer;  ///< as in SurfaceDraw
  gpu::Rect slot;
  glm::vec4 projection{0.0f};  ///< projection matrix [2][2], [3][2], [2][3], [3][3]
  float probe = 3.0f;          ///< px outside a contour at which its own mask makes it an inner one
  glm::vec2 reach{1.0f, 4.0f};  ///< px outside a contour at which the surface has fallen away
  glm::vec4 paint{0.0f};        ///< a fill's colour and opacity, for edges
  glm::vec3 key{0.0f};  ///< the surfaces' key light in the camera's frame, for edges; 0: none
  float sheet = 0.0f;   ///< mm in front of a contour within which its own sheet may lie (see .glsl)
};

class InkPass {
 public:
  static Result<std::unique_ptr<InkPass>> create(gpu::Dialect dialect);
  void upload(std::span<const InkSegment> segments);
  /// Target: ink coverage (or fills, for edges) and the layer's depth. Its own surface hides lines
  /// by `surfaceDepth`.
  void draw(gpu::Device& device, const gpu::Target& target, const gpu::Texture& surfaceDepth,
            const InkDraw& draw);

 private:
  InkPass();
  std::array<std::unique_ptr<gpu::Program>, 3> m_programs;  ///< by InkKind
  gpu::Buffer m_segments;
  gpu::Geometry m_geometry;
};

}  // namespace sline::render::passes
