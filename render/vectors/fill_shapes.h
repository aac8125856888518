// SPDX-License-Identifier: Apache-2.0
// Turns fills into flat shapes that are painted one over the other: each tone covers all that is at
// least as light, so that no seams show between them.
#pragma once

#include "render/vectors/pen_shapes.h"
#include "render/vectors/tone_images.h"

namespace sline::render {

struct FillShapes {
  std::optional<VectorTones> tones;  ///< painted first
  std::vector<VectorShape> shapes;
  float opacity = 1.0f;  ///< of all the shapes together
};

/// Returns the shapes of what is seen of a fill. Where there is an image of the surface's tones,
/// only its edge and the cut faces are shapes.
FillShapes fillShapes(const SeenTones& seen, const ToneImage& image, const PageMapping& page);

}  // namespace sline::render
