// SPDX-License-Identifier: Apache-2.0
// Marks squares of a picture: where layers show, or look at themselves (METHOD §10).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "render/raster/pixel_rect.h"

namespace sline::render {

/// Marks squares of a region's grid, or of its continuation where an area reaches beyond the
/// region.
class TileMask {
 public:
  static constexpr int side = 16;  ///< of a square, px

  TileMask() = default;
  /// Takes `region` in pixels of the whole picture; its squares start at its lower left corner.
  explicit TileMask(const PixelRect& region) : TileMask(region, region) {}
  /// Holds those squares of the region's grid that the area touches.
  TileMask(const PixelRect& region, const PixelRect& area);

  void mark(const PixelRect& area);
  /// Also marks squares that the other mask, which must have the same grid, marks in both's area.
  void mark(const TileMask& other);
  /// Takes the marks from squares for which test(column, row) holds, of the region's grid.
  template <class Test>
  void unmarkIf(const Test& test) {
    for (int row = 0; row < m_rows; ++row)
      for (int column = 0; column < m_columns; ++column) {
        std::uint8_t& marked = m_marked[std::size_t(row) * m_columns + column];
        if (marked != 0 && test(m_firstColumn + column, m_firstRow + row))
          marked = 0;
      }
  }
  void markAll() { std::fill(m_marked.begin(), m_marked.end(), std::uint8_t(1)); }
  /// Takes the square's place in the region's grid, within the area or not.
  bool marked(int column, int row) const {
    const int x = column - m_firstColumn;
    const int y = row - m_firstRow;
    return x >= 0 && x < m_columns && y >= 0 && y < m_rows &&
           m_marked[std::size_t(y) * m_columns + x] != 0;
  }
  /// Tells whether a square is marked that touches these pixels.
  bool marksAny(const PixelRect& pixels) const;
  /// Returns the square's pixels within the area, from the region's lower left corner.
  PixelRect square(int column, int row) const;
  /// Returns the marked squares joined to rectangles, in pixels of the picture and within the area.
  std::vector<PixelRect> rectangles() const;
  int columns() const { return m_columns; }
  int rows() const { return m_rows; }

 private:
  /// Squares of the mask, the last ones included, that pixels touch.
  struct Span {
    int left = 0;
    int right = -1;
    int bottom = 0;
    int top = -1;
  };
  Span span(const PixelRect& pixels) const;

  glm::ivec2 m_corner{0};  ///< of the first square, in pixels of the picture
  PixelRect m_area;
  int m_firstColumn = 0;
  int m_firstRow = 0;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<std::uint8_t> m_marked;
};

}  // namespace sline::render
