// SPDX-License-Identifier: Apache-2.0
// Writes a drawing as layers of an SVG document: the fills and above them the lines, with a group
// for each structure.
#pragma once

#include <string>

#include "model/scene/scene.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

struct SvgDrawingStyle {
  std::string prefix;  ///< of all ids, which tells drawings of one document apart
  int decimals = 3;
};

/// Appends the layers. Lines lie in groups nested as the scene's tree is, the farther below the
/// nearer, with the names that the scene has.
void appendSvgDrawing(std::string& text, const VectorDrawing& drawing, const model::Scene& scene,
                      const SvgDrawingStyle& style);

}  // namespace sline::render
