// SPDX-License-Identifier: Apache-2.0
// Finds where a value of the vertices is greatest along a direction that each vertex has up to its
// sign, within one triangle (Judd et al., "Apparent ridges for line drawing", SIGGRAPH 2007, fig.
// 6; Ohtake et al., "Ridge-valley lines on meshes via implicit surface fitting", SIGGRAPH 2004).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/lines/ground/line_clip.h"

namespace sline::render {

struct CrestCorner {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
  float nv = 0.0f;
  glm::vec3 axis{0.0f};  ///< unit vector along which the value is compared, or its opposite
  /// The axis, turned so that the value rises along it, times how fast it does so.
  glm::vec3 rise{0.0f};
  float strength = 0.0f;
};

struct CrestTriangle {
  std::uint32_t triangle = 0;
  std::array<CrestCorner, 3> corners;
};

/// Returns the pieces of crests in the triangle, each from edge to edge, or three from its edges to
/// its middle where the value is greatest there. Nothing is returned where the corners' axes differ
/// by more than 45°, as near umbilics, and where the value is least.
std::vector<std::array<LineEnd, 2>> crestsIn(const CrestTriangle& triangle);

/// Appends what is drawn of them.
void appendCrests(const CrestTriangle& triangle, const LineClip& clip,
                  std::vector<Segment>& segments);

}  // namespace sline::render
