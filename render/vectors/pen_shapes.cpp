// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/pen_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/vectors/bezier_fit.h"

namespace sline::render {

namespace {

// A pen's widths come in steps of so many pixels: strokes that differ by less share a path.
constexpr float penStep = 0.25f;
// A stroke counts as one of constant width where it varies by less than this share.
constexpr float evenness = 0.12f;
// The distance of the controls of a quarter of a circle, as a share of the radius.
constexpr float quarterControl = 0.5522847498f;
// The distance for half a circle.
constexpr float halfControl = 4.0f / 3.0f;

glm::vec2 unit(const glm::vec2& v, const glm::vec2& otherwise) {
  const float length = glm::length(v);
  return length > 1e-6f ? v / length : otherwise;
}

glm::vec2 leftOf(const glm::vec2& direction) {
  return {-direction.y, direction.x};
}

/// Appends what `appendHalfCircle` appends, but as a single cubic, which deviates from the circle
/// by 2 % of the radius.
void appendCap(Curve& curve, const StrokePoint& end, const glm::vec2& side,
               const glm::vec2& forwards) {
  const glm::vec2 s = end.halfWidth * side;
  const glm::vec2 f = end.halfWidth * halfControl * forwards;
  curve.pieces.push_back({end.at + s + f, end.at - s + f, end.at - s});
}

/// Appends half a circle around `centre`, from centre + radius·side forwards to the other side.
void appendHalfCircle(Curve& curve, const glm::vec2& centre, float radius, const glm::vec2& side,
                      const glm::vec2& forwards) {
  const glm::vec2 s = radius * side;
  const glm::vec2 f = radius * forwards;
  curve.pieces.push_back(
      {centre + s + quarterControl * f, centre + f + quarterControl * s, centre + f});
  curve.pieces.push_back(
      {centre + f - quarterControl * s, centre - s + quarterControl * f, centre - s});
}

Curve disc(const StrokePoint& point) {
  const glm::vec2 x(1.0f, 0.0f);
  const glm::vec2 y(0.0f, 1.0f);
  Curve curve{.start = point.at + point.halfWidth * x, .pieces = {}, .closed = true};
  appendHalfCircle(curve, point.at, point.halfWidth, x, y);
  appendHalfCircle(curve, point.at, point.halfWidth, -x, -y);
  return curve;
}

/// Returns what a veil leaves of the light, in steps below 1.
float lightBehind(const Veil& veil) {
  constexpr float steps = 16.0f;
  return std::clamp(std::round(veil.transmittance * steps), 1.0f, steps - 1.0f) / steps;
}

/// Rounds colours of veiled lines to steps, so that they share paths.
Colour stepped(const Colour& colour) {
  const auto channel = [](std::uint8_t value) {
    return std::uint8_t(std::min((int(value) + 6) / 12 * 12, 255));
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

}  // namespace

bool isEven(std::span<const StrokePoint> points) {
  float low = points.front().halfWidth;
  float high = low;
  for (const StrokePoint& p : points) {
    low = std::min(low, p.halfWidth);
    high = std::max(high, p.halfWidth);
  }
  return high - low <= evenness * high;
}

float meanWidth(std::span<const StrokePoint> points) {
  double sum = 0.0;
  for (const StrokePoint& p : points)
    sum += 2.0 * double(p.halfWidth);
  return float(sum / double(points.size()));
}

Colour behind(const Veil& veil, const Colour& ink) {
  const auto channel = [&veil](float before, std::uint8_t own) {
    const float value = 255.0f * before + veil.transmittance * float(own);
    return std::uint8_t(std::clamp(std::lround(value), 0l, 255l));
  };
  return {channel(veil.colour.r, ink.red), channel(veil.colour.g, ink.green),
          channel(veil.colour.b, ink.blue)};
}

Curve PageMapping::toPage(Curve curve) const {
  curve.start = toPage(curve.start);
  for (Cubic& piece : curve.pieces)
    piece = {toPage(piece.control1), toPage(piece.control2), toPage(piece.end)};
  return curve;
}

Curve strokeOutline(std::span<const StrokePoint> points, float tolerance) {
  std::vector<glm::vec2> left;
  std::vector<glm::vec2> right;
  glm::vec2 direction(1.0f, 0.0f);
  glm::vec2 first(0.0f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i >= 2 ? i - 2 : 0;
    const std::size_t after = std::min(i + 2, points.size() - 1);
    direction = unit(points[after].at - points[before].at, direction);
    if (i == 0)
      first = direction;
    left.push_back(points[i].at + points[i].halfWidth * leftOf(direction));
    right.push_back(points[i].at - points[i].halfWidth * leftOf(direction));
  }
  std::reverse(right.begin(), right.end());
  // Corners of the middle line are round on its outer side.
  const FitOptions options{.tolerance = tolerance, .corner = 1.6f};
  Curve outline = fittedCurve(left, options);
  appendCap(outline, points.back(), leftOf(direction), direction);
  const Curve back = fittedCurve(right, options);
  outline.pieces.insert(outline.pieces.end(), back.pieces.begin(), back.pieces.end());
  appendCap(outline, points.front(), -leftOf(first), -first);
  outline.closed = true;
  return outline;
}

Path& PenShapes::pathOf(const Key& key) {
  return m_paths[key];
}

void PenShapes::add(const VisibleStroke& stroke, const Colour& ink) {
  const bool veiled = stroke.veil.transmittance < 0.98f;
  const Colour colour = veiled ? stepped(behind(stroke.veil, ink)) : ink;
  const float light = veiled ? lightBehind(stroke.veil) : 1.0f;
  const std::span<const StrokePoint> points(stroke.points);
  if (points.size() == 1) {
    pathOf({light, colour, 0}).push_back(m_page.toPage(disc(points.front())));
    return;
  }
  if (!isEven(points)) {
    pathOf({light, colour, 0}).push_back(m_page.toPage(strokeOutline(points, m_tolerance)));
    return;
  }
  const int pen = std::max(1, int(std::lround(meanWidth(points) / penStep)));
  std::vector<glm::vec2> middle;
  middle.reserve(points.size());
  for (const StrokePoint& p : points)
    middle.push_back(p.at);
  const Curve curve = stroke.closed ? fittedLoop(middle, m_tolerance)
                                    : fittedCurve(middle, {.tolerance = m_tolerance});
  if (!curve.pieces.empty())
    pathOf({light, colour, pen}).push_back(m_page.toPage(curve));
}

std::vector<VectorShape> PenShapes::take() {
  std::vector<VectorShape> shapes;
  for (auto& [key, path] : m_paths)
    shapes.push_back({.path = std::move(path),
                      .colour = key.colour,
                      .opacity = 1.0f,
                      .penWidth = float(key.pen) * penStep * m_page.mmPerPixel,
                      .light = key.light});
  m_paths.clear();
  return shapes;
}

}  // namespace sline::render
