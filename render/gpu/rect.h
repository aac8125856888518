// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace sline::render::gpu {

/// Pixels x … x + width − 1, y … y + height − 1. In a target y counts from the bottom row, as in
/// OpenGL.
struct Rect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
  int right() const { return x + width; }
  int top() const { return y + height; }
  bool operator==(const Rect&) const = default;
};

/// What both rectangles share; empty where they do not touch.
inline Rect intersection(const Rect& a, const Rect& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.right(), b.right()) - x),
          std::max(0, std::min(a.top(), b.top()) - y)};
}

/// The rectangle with `margin` more pixels on every side.
inline Rect grown(const Rect& r, int margin) {
  return {r.x - margin, r.y - margin, r.width + 2 * margin, r.height + 2 * margin};
}

}  // namespace sline::render::gpu
