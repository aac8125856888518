// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace sline::render {

/// Holds pixels x … x + width − 1, y … y + height − 1. In pictures that are drawn y counts from the
/// bottom row, as in OpenGL; in an `Image` from the top.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
  int right() const { return x + width; }
  int top() const { return y + height; }
  bool operator==(const PixelRect&) const = default;
};

/// Returns what both rectangles share; empty where they do not touch.
inline PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.right(), b.right()) - x),
          std::max(0, std::min(a.top(), b.top()) - y)};
}

/// Returns the smallest rectangle that holds both; an empty one is ignored.
inline PixelRect united(const PixelRect& a, const PixelRect& b) {
  if (a.empty())
    return b;
  if (b.empty())
    return a;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.top(), b.top()) - y};
}

/// Returns the rectangle with `margin` more pixels on every side.
inline PixelRect grown(const PixelRect& r, int margin) {
  return {r.x - margin, r.y - margin, r.width + 2 * margin, r.height + 2 * margin};
}

/// Returns the squares of `step` pixels that the rectangle touches, counted from pixel 0.
inline PixelRect coarser(const PixelRect& r, int step) {
  const auto below = [step](int x) { return x >= 0 ? x / step : -((step - 1 - x) / step); };
  const int x = below(r.x);
  const int y = below(r.y);
  return {x, y, below(r.right() + step - 1) - x, below(r.top() + step - 1) - y};
}

}  // namespace sline::render
