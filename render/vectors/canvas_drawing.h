// SPDX-License-Identifier: Apache-2.0
// Draws a scene for a canvas that has no OpenGL: fills as pixels, and the picture's own lines as
// strokes over them, at once and again and again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/scene/scene.h"
#include "render/strokes/picture_settings.h"
#include "render/vectors/structure_work.h"

namespace sline::render {

/// A line of one width, in pixels of the fills from their upper left corner.
struct CanvasStroke {
  Colour colour;
  float opacity = 1.0f;
  float width = 1.0f;
  std::vector<glm::vec2> points;  ///< at least two
};

struct CanvasDrawing {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< of the fills on the ground, rows from the top
  std::vector<CanvasStroke> strokes;
};

class CanvasDrawer {
 public:
  /// Draws as `drawVectors` does, with fills of one tone per pixel. Lines are hidden by depths of
  /// that many pixels; they may be drawn at any scale.
  CanvasDrawing draw(const model::Scene& scene, const model::Camera& camera,
                     const PictureSettings& settings);

 private:
  KeptSurfaces m_surfaces;
};

}  // namespace sline::render
