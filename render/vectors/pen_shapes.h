// SPDX-License-Identifier: Apache-2.0
// Turns strokes into shapes: those of one width into paths for a round pen, the others into
// outlines.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "render/vectors/vector_drawing.h"
#include "render/vectors/visible_strokes.h"

namespace sline::render {

/// Maps pixels of the picture, y upwards, to the page.
struct PageMapping {
  float mmPerPixel = 1.0f;
  float heightMm = 1.0f;

  glm::vec2 toPage(const glm::vec2& pixel) const {
    return {pixel.x * mmPerPixel, heightMm - pixel.y * mmPerPixel};
  }
  Curve toPage(Curve curve) const;
};

/// Collects strokes and makes one shape of those that share colour and pen.
class PenShapes {
 public:
  /// Starts an empty collection; `tolerance` is that of curves, in pixels.
  PenShapes(const PageMapping& page, float tolerance) : m_page(page), m_tolerance(tolerance) {}

  void add(const VisibleStroke& stroke, const Colour& ink);
  /// Returns the shapes in an order that depends only on what was added.
  std::vector<VectorShape> take();

 private:
  struct Key {
    float light = 1.0f;  ///< see VectorShape
    Colour colour;
    int pen = 0;  ///< width in steps; 0: an outline
    auto operator<=>(const Key&) const = default;
  };
  Path& pathOf(const Key& key);

  PageMapping m_page;
  float m_tolerance;
  std::map<Key, Path> m_paths;
};

/// Returns how a line of the ink's colour looks through what lies in front of it.
Colour behind(const Veil& veil, const Colour& ink);
/// Tells whether all points are about as wide.
bool isEven(std::span<const StrokePoint> points);
/// Returns the mean width of the points, which must not be none.
float meanWidth(std::span<const StrokePoint> points);
/// Returns the outline of a stroke of varying width, with round ends; it is closed, in pixels.
Curve strokeOutline(std::span<const StrokePoint> points, float tolerance);

}  // namespace sline::render
