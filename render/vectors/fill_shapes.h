// SPDX-License-Identifier: Apache-2.0
// Turns fills into flat shapes that are painted one over the other: each tone covers all that is at
// least as light (or as dense), so that no seams show between them.
#pragma once

#include "render/vectors/pen_shapes.h"
#include "render/vectors/seen_tones.h"

namespace sline::render {

struct FillShapes {
  std::vector<VectorShape> shapes;
  float opacity = 1.0f;  ///< of all the shapes together
};

/// Returns the shapes of what is seen of a fill; `paper` is the page's colour.
FillShapes fillShapes(const SeenTones& seen, const glm::vec3& paper, const PageMapping& page);

}  // namespace sline::render
