// SPDX-License-Identifier: Apache-2.0
// Describes how a layer's strokes are drawn, and what hides them.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "render/raster/pixel_rect.h"
#include "render/strokes/stroke.h"

namespace sline::render {

/// Tells what strokes draw: ink, the soft edges of a fill along its contours, outlines that show
/// through what lies before them, where lines behind an outline stop, or how far a fill reaches
/// that was enlarged, and what shows beyond.
enum class InkKind { surfaceLines, contours, edges, hidden, halos, trims };
inline constexpr std::size_t inkKindCount = 6;

/// The grain of drawing paper, λ.
inline constexpr float paperGrain = 1.1f;

struct InkDraw {
  InkKind kind = InkKind::surfaceLines;  ///< that of all its strokes
  std::span<const Stroke> strokes;       ///< farthest first
  PixelRect layer;                       ///< as in SurfaceDraw
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

/// Sight is looked for at so many places of a stroke, less one; longer strokes, in pixels, become
/// several.
inline constexpr int mostInkSteps = 15;

/// Returns the number of such pieces, and one of them; together they draw what the stroke draws.
int inkPieces(const Stroke& stroke);
Stroke inkPiece(const Stroke& stroke, int piece, int pieces);
/// Returns at how many places of a piece it is looked for, less one.
int inkSteps(const Stroke& stroke);

}  // namespace sline::render
