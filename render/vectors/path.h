// SPDX-License-Identifier: Apache-2.0
// Smooth paths: cubic Béziers, as every vector format knows them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace sline::render {

/// From where the last piece ended.
struct Cubic {
  glm::vec2 control1{0.0f};
  glm::vec2 control2{0.0f};
  glm::vec2 end{0.0f};
};

/// One stretch of a path. A closed one ends where it starts.
struct Curve {
  glm::vec2 start{0.0f};
  std::vector<Cubic> pieces;
  bool closed = false;
};

using Path = std::vector<Curve>;

}  // namespace sline::render
