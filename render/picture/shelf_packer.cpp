// SPDX-License-Identifier: Apache-2.0
#include "render/picture/shelf_packer.h"

namespace sline::render {

std::optional<PixelRect> ShelfPacker::place(int width, int height) {
  Shelf* best = nullptr;
  for (Shelf& shelf : m_shelves)
    if (shelf.height >= height && m_size.width - shelf.used >= width &&
        (!best || shelf.height < best->height))
      best = &shelf;
  if (!best) {
    if (width > m_size.width || height > m_size.height - m_top)
      return std::nullopt;
    m_shelves.push_back({m_top, height, 0});
    m_top += height;
    best = &m_shelves.back();
  }
  const PixelRect placed{best->used, best->y, width, height};
  best->used += width;
  return placed;
}

}  // namespace sline::render
