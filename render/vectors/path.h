// SPDX-License-Identifier: Apache-2.0
// Smooth paths made of cubic Béziers, which every vector format knows.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace sline::render {

/// A cubic Bézier that starts where the piece before it ended.
struct Cubic {
  glm::vec2 control1{0.0f};
  glm::vec2 control2{0.0f};
  glm::vec2 end{0.0f};
};

/// One stretch of a path; a closed one ends where it starts.
struct Curve {
  glm::vec2 start{0.0f};
  std::vector<Cubic> pieces;
  bool closed = false;
};

using Path = std::vector<Curve>;

}  // namespace sline::render
