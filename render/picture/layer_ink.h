// SPDX-License-Identifier: Apache-2.0
// Lists what is inked on a layer, in the order in which it is drawn.
#pragma once

#include <vector>

#include "render/picture/layer_painter.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// Returns what changes the fills: their soft edges or, where they are enlarged, trims. The draws
/// name the layer's strokes.
std::vector<InkDraw> edgeDraws(const PictureInput& input, const Layer& layer);
/// Returns what is drawn on the fills after that.
std::vector<InkDraw> strokeDraws(const PictureInput& input, const Layer& layer);
/// Returns the direction towards the key light, in the camera's frame; 0: there is none.
glm::vec3 keyLight(const PictureInput& input);
/// Forgets the layer's strokes, which have been drawn.
void forgetStrokes(Layer& layer);

}  // namespace sline::render
