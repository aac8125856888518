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

struct FilledLayer {
  const DepthLayer& layer;
  std::size_t index = 0;  ///< in the stack
  /// Of each layer of the stack: those of higher rank are painted later.
  std::span<const std::size_t> ranks;
};

/// What of the layer's fill other fills do not hide.
FillShapes fillShapes(const FilledLayer& filled, const LayerStack& stack, const PageMapping& page);

/// Mean depth of the layer's pixels, 0 … 1.
float meanDepth(const DepthLayer& layer);

}  // namespace sline::render
