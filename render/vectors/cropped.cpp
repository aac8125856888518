// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/cropped.h"

#include <glm/common.hpp>

namespace sline::render {

namespace {

void move(Path& path, const glm::vec2& by) {
  for (Curve& curve : path) {
    curve.start += by;
    for (Cubic& piece : curve.pieces) {
      piece.control1 += by;
      piece.control2 += by;
      piece.end += by;
    }
  }
}

/// Tells whether a pen of that width along the curve may touch the rectangle from the origin on.
bool touches(const Curve& curve, const glm::vec2& size, float pen) {
  glm::vec2 low = curve.start;
  glm::vec2 high = curve.start;
  for (const Cubic& piece : curve.pieces)
    for (const glm::vec2& point : {piece.control1, piece.control2, piece.end}) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  return low.x <= size.x + pen && low.y <= size.y + pen && high.x >= -pen && high.y >= -pen;
}

void crop(std::vector<VectorShape>& shapes, const glm::vec2& corner, const glm::vec2& size) {
  for (VectorShape& shape : shapes) {
    move(shape.path, -corner);
    std::erase_if(shape.path,
                  [&](const Curve& curve) { return !touches(curve, size, shape.penWidth); });
  }
  std::erase_if(shapes, [](const VectorShape& shape) { return shape.path.empty(); });
}

}  // namespace

VectorDrawing cropped(VectorDrawing drawing, const glm::vec2& corner, const glm::vec2& sizeMm) {
  drawing.sizeMm = sizeMm;
  for (VectorStructure& structure : drawing.structures) {
    if (structure.tones) {
      structure.tones->at -= corner;
      move(structure.tones->edge, -corner);
      std::erase_if(structure.tones->edge,
                    [&](const Curve& curve) { return !touches(curve, sizeMm, 0.0f); });
      if (structure.tones->edge.empty())
        structure.tones.reset();
    }
    crop(structure.fills, corner, sizeMm);
    for (VectorLines& lines : structure.lines)
      crop(lines.shapes, corner, sizeMm);
    std::erase_if(structure.lines, [](const VectorLines& lines) { return lines.shapes.empty(); });
  }
  std::erase_if(drawing.structures, [](const VectorStructure& structure) {
    return !structure.filled() && structure.lines.empty();
  });
  return drawing;
}

}  // namespace sline::render
