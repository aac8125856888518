// SPDX-License-Identifier: Apache-2.0
// Places rectangles in an atlas row by row. Placed rectangles stay; the same sizes in the same
// order give the same places.
#pragma once

#include <optional>
#include <vector>

#include "render/gpu/texture.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

class ShelfPacker {
 public:
  explicit ShelfPacker(gpu::TextureSize size = {}) : m_size(size) {}

  /// Places a rectangle; returns nothing where there is no room.
  std::optional<PixelRect> place(int width, int height);
  /// Limits the height from now on.
  void limitHeight(int height) { m_size.height = height; }
  /// Returns the rows in use, from the bottom.
  int usedHeight() const { return m_top; }

 private:
  struct Shelf {
    int y;
    int height;
    int used;
  };
  gpu::TextureSize m_size;
  std::vector<Shelf> m_shelves;
  int m_top = 0;
};

}  // namespace sline::render
