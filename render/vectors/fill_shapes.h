// SPDX-License-Identifier: Apache-2.0
// Fills as flat shapes, painted one over the other: each tone covers all that is at least as light
// (or as dense), so that no seams show between them.
#pragma once

#include "render/vectors/layer_stack.h"
#include "render/vectors/pen_shapes.h"

namespace sline::render {

struct FillShapes {
  std::vector<VectorShape> shapes;
  float opacity = 1.0f;  ///< of all of them together
};

/// What of the layer's fill other fills do not hide.
FillShapes fillShapes(const DepthLayer& layer, std::size_t index, const LayerStack& stack,
                      const PageMapping& page);

/// Mean depth of the layer's pixels, 0 … 1.
float meanDepth(const DepthLayer& layer);

}  // namespace sline::render
