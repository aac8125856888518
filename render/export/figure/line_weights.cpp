// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/line_weights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>
#include <utility>

namespace sline::render {

namespace {

/// The length of a curve along its middle and its mean width, millimetres.
struct MeasuredStroke {
  float length = 0.0f;
  float width = 0.0f;
};

/// Returns the length along the curve and the area that they enclose, twice.
std::pair<double, double> lengthAndArea(const Curve& curve) {
  double length = 0.0;
  double area = 0.0;
  glm::dvec2 last(curve.start);
  const auto to = [&](const glm::vec2& next) {
    const glm::dvec2 point(next);
    length += glm::distance(last, point);
    area += last.x * point.y - last.y * point.x;
    last = point;
  };
  for (const Cubic& piece : curve.pieces) {
    const glm::vec2 start(last);
    for (const float t : {0.25f, 0.5f, 0.75f, 1.0f}) {
      const float u = 1.0f - t;
      to(u * u * u * start + 3.0f * u * u * t * piece.control1 + 3.0f * u * t * t * piece.control2 +
         t * t * t * piece.end);
    }
  }
  if (curve.closed)
    to(curve.start);
  return {length, std::abs(area)};
}

/// Returns a stroke as long and, in the mean, as wide as the curve is drawn.
MeasuredStroke strokeOf(const VectorShape& shape, const Curve& curve) {
  const auto [length, doubleArea] = lengthAndArea(curve);
  if (shape.penWidth > 0.0f)
    return {float(length), shape.penWidth};
  return {float(0.5 * length), length > 0.0 ? float(doubleArea / length) : 0.0f};
}

/// Appends the shape, at least that wide: a pen is made wider, and an outline that is thinner in
/// the mean is drawn along with a pen that fills it up.
void appendRaised(std::vector<VectorShape>& raised, VectorShape shape, float leastMm) {
  if (shape.penWidth > 0.0f) {
    shape.penWidth = std::max(shape.penWidth, leastMm);
    raised.push_back(std::move(shape));
    return;
  }
  constexpr float step = 0.005f;  // millimetres; strokes that differ by less share a pen
  std::map<int, VectorShape> pens;
  for (const Curve& curve : shape.path) {
    const float width = strokeOf(shape, curve).width;
    if (width >= leastMm)
      continue;
    VectorShape& pen = pens[int((leastMm - width) / step)];
    pen.penWidth = std::max(pen.penWidth, leastMm - width);
    pen.path.push_back(curve);
  }
  for (auto& [width, pen] : pens) {
    pen.colour = shape.colour;
    pen.opacity = shape.opacity;
    pen.light = shape.light;
  }
  raised.push_back(std::move(shape));
  for (auto& [width, pen] : pens)
    raised.push_back(std::move(pen));
}

}  // namespace

bool isTone(const VectorLines& lines) {
  const std::string_view kind = lines.kind;
  return kind == hatchingLayer || kind == cutTissueLayer;
}

float usualWidthMm(const VectorLines& lines) {
  std::vector<MeasuredStroke> strokes;
  float whole = 0.0f;
  for (const VectorShape& shape : lines.shapes)
    for (const Curve& curve : shape.path) {
      strokes.push_back(strokeOf(shape, curve));
      whole += strokes.back().length;
    }
  std::sort(strokes.begin(), strokes.end(),
            [](const MeasuredStroke& a, const MeasuredStroke& b) { return a.width < b.width; });
  float passed = 0.0f;
  for (const MeasuredStroke& stroke : strokes) {
    passed += stroke.length;
    if (passed >= 0.5f * whole)
      return stroke.width;
  }
  return std::numeric_limits<float>::infinity();
}

void raiseLines(VectorDrawing& drawing, float leastMm) {
  for (VectorStructure& structure : drawing.structures)
    for (VectorLines& lines : structure.lines) {
      if (isTone(lines))
        continue;
      std::vector<VectorShape> raised;
      for (VectorShape& shape : lines.shapes)
        appendRaised(raised, std::move(shape), leastMm);
      lines.shapes = std::move(raised);
    }
}

}  // namespace sline::render
