// SPDX-License-Identifier: Apache-2.0
// Cuts lines where they are hidden, by the rules of the ink and resolve passes.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/strokes/structure_lines.h"
#include "render/vectors/ink_chains.h"
#include "render/vectors/layer_stack.h"

namespace sline::render {

struct StrokePoint {
  glm::vec2 at{0.0f};  ///< pixels of the picture, the stroke's middle
  float halfWidth = 0.0f;
  float depth = 1.0f;  ///< window depth of the line itself
};

/// A visible piece of a line has a point for each pixel along its way.
struct VisibleStroke {
  std::vector<StrokePoint> points;
  bool closed = false;  ///< it is the whole of a line without ends
  Veil veil;            ///< what lies in front of it, the same along all of it
};

/// Describes one structure's lines and what may hide them.
struct StrokeScene {
  const LayerStack& stack;
  const DepthLayer& own;
  std::size_t ownIndex = 0;
  glm::vec4 projection{0.0f};  ///< see depth.glsl
  ContourProbes probes;
  bool hidden = false;  ///< wanted are the parts that others hide, whole
  float ink = 1.0f;  ///< the opacity of a whole line; lines of less opacity become thinner instead
};

/// Returns the parts of the strokes that lie within a page of that size, or within half their width
/// of it.
std::vector<VisibleStroke> withinPage(std::vector<VisibleStroke> strokes, const glm::vec2& page);

std::vector<VisibleStroke> visibleStrokes(const InkChain& chain, const StrokeScene& scene);

}  // namespace sline::render
