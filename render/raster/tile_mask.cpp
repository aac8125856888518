// SPDX-License-Identifier: Apache-2.0
#include "render/raster/tile_mask.h"

namespace sline::render {

namespace {

/// Divides by the side of a square and rounds down.
int squareAt(int pixels) {
  constexpr int side = TileMask::side;
  return pixels >= 0 ? pixels / side : -((-pixels + side - 1) / side);
}

}  // namespace

TileMask::TileMask(const PixelRect& region, const PixelRect& area)
    : m_area(area),
      m_firstColumn(squareAt(area.x - region.x)),
      m_firstRow(squareAt(area.y - region.y)) {
  m_corner = {region.x + side * m_firstColumn, region.y + side * m_firstRow};
  m_columns = (area.right() - m_corner.x + side - 1) / side;
  m_rows = (area.top() - m_corner.y + side - 1) / side;
  m_marked.assign(std::size_t(m_columns) * m_rows, 0);
}

TileMask::Span TileMask::span(const PixelRect& pixels) const {
  const PixelRect seen = intersection(pixels, m_area);
  if (seen.empty())
    return {};
  return {.left = (seen.x - m_corner.x) / side,
          .right = (seen.right() - 1 - m_corner.x) / side,
          .bottom = (seen.y - m_corner.y) / side,
          .top = (seen.top() - 1 - m_corner.y) / side};
}

void TileMask::mark(const PixelRect& area) {
  const Span s = span(area);
  for (int row = s.bottom; row <= s.top; ++row)
    std::fill_n(m_marked.begin() + std::ptrdiff_t(row) * m_columns + s.left, s.right - s.left + 1,
                std::uint8_t(1));
}

void TileMask::mark(const TileMask& other) {
  for (int row = 0; row < m_rows; ++row)
    for (int column = 0; column < m_columns; ++column)
      if (other.marked(m_firstColumn + column, m_firstRow + row))
        m_marked[std::size_t(row) * m_columns + column] = 1;
}

bool TileMask::marksAny(const PixelRect& pixels) const {
  const Span s = span(pixels);
  for (int row = s.bottom; row <= s.top; ++row)
    for (int column = s.left; column <= s.right; ++column)
      if (m_marked[std::size_t(row) * m_columns + column] != 0)
        return true;
  return false;
}

std::vector<PixelRect> TileMask::rectangles() const {
  std::vector<PixelRect> found;
  std::size_t below = 0;  // where the rectangles start that end at the row before
  for (int row = 0; row < m_rows; ++row) {
    const std::size_t here = found.size();
    const std::uint8_t* marked = m_marked.data() + std::size_t(row) * m_columns;
    for (int column = 0; column < m_columns; ++column) {
      if (marked[column] == 0)
        continue;
      const int first = column;
      while (column < m_columns && marked[column] != 0)
        ++column;
      found.push_back(
          {m_corner.x + side * first, m_corner.y + side * row, side * (column - first), side});
    }
    for (std::size_t i = here; i < found.size(); ++i)
      for (std::size_t k = below; k < here; ++k)
        if (found[k].x == found[i].x && found[k].width == found[i].width &&
            found[k].top() == found[i].y) {
          found[i] = united(found[k], found[i]);
          found[k] = {};
        }
    below = here;
  }
  std::erase_if(found, [](const PixelRect& rect) { return rect.empty(); });
  for (PixelRect& rect : found)
    rect = intersection(rect, m_area);
  return found;
}

PixelRect TileMask::square(int column, int row) const {
  const glm::ivec2 region = m_corner - side * glm::ivec2(m_firstColumn, m_firstRow);
  return intersection({side * column, side * row, side, side},
                      {m_area.x - region.x, m_area.y - region.y, m_area.width, m_area.height});
}

}  // namespace sline::render
