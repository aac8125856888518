// SPDX-License-Identifier: Apache-2.0
// Strokes as shapes: those of one width as paths for a round pen, the others as outlines.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "render/vectors/vector_drawing.h"
#include "render/vectors/visible_strokes.h"

namespace sline::render {

/// From pixels of the picture, y upwards, to the page.
struct PageMapping {
  float mmPerPixel = 1.0f;
  float heightMm = 1.0f;

  glm::vec2 toPage(const glm::vec2& pixel) const {
    return {pixel.x * mmPerPixel, heightMm - pixel.y * mmPerPixel};
  }
  Curve toPage(Curve curve) const;
};

/// Collects strokes; those of one colour and pen become one shape.
class PenShapes {
 public:
  /// `tolerance` of curves in pixels.
  PenShapes(const PageMapping& page, float tolerance) : m_page(page), m_tolerance(tolerance) {}

  void add(const VisibleStroke& stroke, const Colour& ink);
  /// In an order that depends on nothing but what was added.
  std::vector<VectorShape> take();

 private:
  struct Key {
    Colour colour;
    int pen = 0;  ///< width in steps; 0: outlines
    auto operator<=>(const Key&) const = default;
  };
  Path& pathOf(const Key& key);

  PageMapping m_page;
  float m_tolerance;
  std::map<Key, Path> m_paths;
};

/// The outline of a stroke whose width varies, with round ends; closed, pixels.
Curve strokeOutline(std::span<const StrokePoint> points, float tolerance);

}  // namespace sline::render
