// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/bezier_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {

using Points = std::span<const glm::vec2>;

glm::vec2 unit(const glm::vec2& v) {
  const float length = glm::length(v);
  return length > 1e-12f ? v / length : glm::vec2(0.0f);
}

glm::vec2 at(const std::array<glm::vec2, 4>& p, float t) {
  const float s = 1.0f - t;
  return s * s * s * p[0] + 3.0f * s * s * t * p[1] + 3.0f * s * t * t * p[2] + t * t * t * p[3];
}

/// Returns how far along each point lies, 0 … 1, by the length of the chords between them.
std::vector<float> chordParameters(Points points) {
  std::vector<float> u(points.size(), 0.0f);
  for (std::size_t i = 1; i < points.size(); ++i)
    u[i] = u[i - 1] + glm::distance(points[i], points[i - 1]);
  const float whole = std::max(u.back(), 1e-20f);
  for (float& value : u)
    value /= whole;
  return u;
}

struct Tangents {
  glm::vec2 start;  ///< unit, into the curve
  glm::vec2 end;    ///< unit, back into the curve
};

/// Returns the cubic with these end tangents that is nearest to the points in the sense of least
/// squares.
std::array<glm::vec2, 4> leastSquares(Points points, const std::vector<float>& u,
                                      const Tangents& tangents) {
  const glm::vec2 p0 = points.front();
  const glm::vec2 p3 = points.back();
  double c00 = 0.0;
  double c01 = 0.0;
  double c11 = 0.0;
  double x0 = 0.0;
  double x1 = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float t = u[i];
    const float s = 1.0f - t;
    const glm::vec2 a0 = 3.0f * s * s * t * tangents.start;
    const glm::vec2 a1 = 3.0f * s * t * t * tangents.end;
    const glm::vec2 rest = points[i] - at({p0, p0, p3, p3}, t);
    c00 += double(glm::dot(a0, a0));
    c01 += double(glm::dot(a0, a1));
    c11 += double(glm::dot(a1, a1));
    x0 += double(glm::dot(a0, rest));
    x1 += double(glm::dot(a1, rest));
  }
  const double determinant = c00 * c11 - c01 * c01;
  const float chord = glm::distance(p0, p3);
  double first = 0.0;
  double second = 0.0;
  if (std::abs(determinant) > 1e-12) {
    first = (x0 * c11 - x1 * c01) / determinant;
    second = (c00 * x1 - c01 * x0) / determinant;
  }
  // Wu and Barsky's rule, as Schneider has it, for where least squares give no usable result.
  const double least = 1e-3 * double(chord);
  const double most = 4.0 * double(chord);
  if (!(first > least && second > least && first < most && second < most))
    first = second = double(chord) / 3.0;
  return {p0, p0 + float(first) * tangents.start, p3 + float(second) * tangents.end, p3};
}

/// Takes one step of Newton's method towards the nearest point of the curve.
float nearer(const std::array<glm::vec2, 4>& p, const glm::vec2& point, float t) {
  const float s = 1.0f - t;
  const glm::vec2 off = at(p, t) - point;
  const glm::vec2 d1 =
      3.0f * (s * s * (p[1] - p[0]) + 2.0f * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
  const glm::vec2 d2 = 6.0f * (s * (p[2] - 2.0f * p[1] + p[0]) + t * (p[3] - 2.0f * p[2] + p[1]));
  const float slope = glm::dot(d1, d1) + glm::dot(off, d2);
  if (std::abs(slope) < 1e-12f)
    return t;
  return std::clamp(t - glm::dot(off, d1) / slope, 0.0f, 1.0f);
}

struct Worst {
  float squared = 0.0f;
  std::size_t index = 0;
};
Worst worst(Points points, const std::vector<float>& u, const std::array<glm::vec2, 4>& p) {
  Worst found{.squared = 0.0f, .index = points.size() / 2};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const glm::vec2 off = at(p, u[i]) - points[i];
    if (glm::dot(off, off) > found.squared)
      found = {glm::dot(off, off), i};
  }
  return found;
}

/// Returns the direction into the points from one of their ends, over a few of them, as single
/// steps are noisy. Where there are enough points, it is that of the parabola through three of
/// them; otherwise arcs would seem to leave their ends too far inwards.
glm::vec2 endTangent(Points points, bool fromBack) {
  constexpr std::size_t reach = 3;
  const auto point = [&](std::size_t i) {
    return fromBack ? points[points.size() - 1 - i] : points[i];
  };
  if (points.size() > 2 * reach)
    return unit(4.0f * (point(reach) - point(0)) - (point(2 * reach) - point(0)));
  return unit(point(std::min(reach, points.size() - 1)) - point(0));
}

class Fitter {
 public:
  Fitter(float tolerance, std::vector<Cubic>& pieces)
      : m_squared(tolerance * tolerance), m_pieces(pieces) {}

  void fit(Points points, const Tangents& tangents) {
    if (points.size() < 2)
      return;
    if (points.size() == 2) {
      const glm::vec2 third = (points[1] - points[0]) / 3.0f;
      m_pieces.push_back({points[0] + third, points[1] - third, points[1]});
      return;
    }
    std::vector<float> u = chordParameters(points);
    std::array<glm::vec2, 4> p = leastSquares(points, u, tangents);
    Worst off = worst(points, u, p);
    // Up to ten times the tolerance, better parameters can still make it fit, which saves a piece.
    constexpr int steps = 8;
    const float mendable = 100.0f * m_squared;
    for (int i = 0; i < steps && off.squared > m_squared && off.squared < mendable; ++i) {
      for (std::size_t k = 0; k < points.size(); ++k)
        u[k] = nearer(p, points[k], u[k]);
      p = leastSquares(points, u, tangents);
      off = worst(points, u, p);
    }
    if (off.squared <= m_squared) {
      m_pieces.push_back({p[1], p[2], p[3]});
      return;
    }
    // Far from a fit, the worst place says little about where a curve should end, and arcs fall
    // apart into uneven pieces there.
    const std::size_t split = off.squared > 16.0f * m_squared ? points.size() / 2 : off.index;
    const std::size_t reach = std::min({std::size_t(2), split, points.size() - 1 - split});
    const glm::vec2 through = unit(points[split + reach] - points[split - reach]);
    fit(points.first(split + 1), {tangents.start, -through});
    fit(points.subspan(split), {through, tangents.end});
  }

 private:
  float m_squared;
  std::vector<Cubic>& m_pieces;
};

/// Returns the points without repetitions, which have no direction.
std::vector<glm::vec2> distinct(Points points) {
  std::vector<glm::vec2> kept;
  kept.reserve(points.size());
  for (const glm::vec2& p : points)
    if (kept.empty() || glm::distance(kept.back(), p) > 1e-4f)
      kept.push_back(p);
  return kept;
}

bool isCorner(Points points, std::size_t i, float angle) {
  const glm::vec2 in = unit(points[i] - points[i - 1]);
  const glm::vec2 out = unit(points[i + 1] - points[i]);
  return glm::dot(in, out) < std::cos(angle);
}

}  // namespace

Curve fittedCurve(Points given, const FitOptions& options) {
  const std::vector<glm::vec2> points = distinct(given);
  Curve curve;
  if (points.empty())
    return curve;
  curve.start = points.front();
  Fitter fitter(options.tolerance, curve.pieces);
  std::size_t from = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 < points.size() && !isCorner(points, i, options.corner))
      continue;
    const Points part = Points(points).subspan(from, i + 1 - from);
    fitter.fit(part, {endTangent(part, false), endTangent(part, true)});
    from = i;
  }
  return curve;
}

Curve fittedLoop(Points given, float tolerance) {
  std::vector<glm::vec2> points = distinct(given);
  Curve curve;
  curve.closed = true;
  if (points.size() > 1 && glm::distance(points.front(), points.back()) <= 1e-4f)
    points.pop_back();
  if (points.empty())
    return curve;
  curve.start = points.front();
  if (points.size() < 3)
    return curve;
  const glm::vec2 through = unit(points[1] - points.back());
  points.push_back(points.front());
  Fitter(tolerance, curve.pieces).fit(points, {through, -through});
  return curve;
}

}  // namespace sline::render
