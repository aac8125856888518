// SPDX-License-Identifier: Apache-2.0
#include "tests/support/sheet_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace sline::test {

namespace {

constexpr double spacing = 0.25;  // mm
// Numbers next to the edge have no neighbours for their derivatives.
constexpr int edge = 8;

/// Numbers over the sheet's square.
class Grid {
 public:
  explicit Grid(int size) : m_size(size), m_values(std::size_t(size) * std::size_t(size)) {}
  int size() const { return m_size; }
  double& operator()(int i, int j) { return m_values[index(i, j)]; }
  double operator()(int i, int j) const { return m_values[index(i, j)]; }
  /// Returns the derivative by x and y, to fourth order.
  glm::dvec2 slope(int i, int j) const {
    if (i < 2 || j < 2 || i >= m_size - 2 || j >= m_size - 2)
      return glm::dvec2(0.0);
    const Grid& f = *this;
    return glm::dvec2(8.0 * (f(i + 1, j) - f(i - 1, j)) - f(i + 2, j) + f(i - 2, j),
                      8.0 * (f(i, j + 1) - f(i, j - 1)) - f(i, j + 2) + f(i, j - 2)) /
           (12.0 * spacing);
  }
  template <class Value>
  static Grid made(int size, const Value& value) {
    Grid grid(size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        grid(i, j) = value(i, j);
    return grid;
  }

 private:
  std::size_t index(int i, int j) const {
    return std::size_t(i) * std::size_t(m_size) + std::size_t(j);
  }
  int m_size;
  std::vector<double> m_values;
};

/// A technique's lines are where `value` is zero; with an axis, where it falls along that.
struct Zeros {
  explicit Zeros(int size) : value(size), strength(size), u(size), v(size) {}
  Grid value, strength;
  Grid u, v;  ///< the axis in coordinates of the sheet; (0, 0): none
};

class SheetInView {
 public:
  SheetInView(const KnownSheet& sheet, const KnownRequest& request)
      : m_sheet(sheet),
        m_request(request),
        m_size(int(2.0 * sheet.halfSize / spacing) + 1),
        m_zx(Grid::made(m_size, [&](int i, int j) { return sheet.slopeAt(at(i, j)).x; })),
        m_zy(Grid::made(m_size, [&](int i, int j) { return sheet.slopeAt(at(i, j)).y; })),
        m_f(Grid::made(m_size,
                       [&](int i, int j) { return glm::dot(normal(i, j), request.view); })) {}

  Zeros zeros() const {
    switch (m_request.kind) {
      case KnownKind::photic:
        return photic();
      case KnownKind::laplacian:
        return laplacian();
      case KnownKind::apparentRidge:
        return apparent();
      case KnownKind::principalHighlight:
        return principalHighlight();
      case KnownKind::suggestiveHighlight:
        return radial(-1.0);
      default:
        return radial(1.0);
    }
  }

  std::vector<LineSample> lines() const {
    const Zeros found = zeros();
    std::vector<LineSample> samples;
    for (int i = edge; i + 1 + edge < m_size; ++i)
      for (int j = edge; j + 1 + edge < m_size; ++j) {
        appendIn(found, {{{i, j}, {i + 1, j}, {i + 1, j + 1}}}, samples);
        appendIn(found, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}}, samples);
      }
    return samples;
  }

 private:
  using Corners = std::array<glm::ivec2, 3>;

  glm::dvec2 at(int i, int j) const {
    return glm::dvec2(i, j) * spacing - glm::dvec2(m_sheet.halfSize);
  }
  glm::dvec3 normal(int i, int j) const {
    return glm::normalize(glm::dvec3(-m_zx(i, j), -m_zy(i, j), 1.0));
  }
  double metric(int i, int j) const {
    return 1.0 + m_zx(i, j) * m_zx(i, j) + m_zy(i, j) * m_zy(i, j);
  }
  /// Returns the vector that has these products with the sheet's two tangents ∂X/∂x and ∂X/∂y.
  glm::dvec2 raised(int i, int j, const glm::dvec2& a) const {
    const double x = m_zx(i, j);
    const double y = m_zy(i, j);
    return glm::dvec2((1.0 + y * y) * a.x - x * y * a.y, (1.0 + x * x) * a.y - x * y * a.x) /
           metric(i, j);
  }
  glm::dvec2 coordinates(int i, int j, const glm::dvec3& tangent) const {
    return raised(i, j, {tangent.x + m_zx(i, j) * tangent.z, tangent.y + m_zy(i, j) * tangent.z});
  }

  Zeros photic() const {
    Zeros z(m_size);
    const Grid steep = Grid::made(m_size, [&](int i, int j) {
      return glm::dot(m_f.slope(i, j), raised(i, j, m_f.slope(i, j)));
    });
    for (int i = 0; i < m_size; ++i)
      for (int j = 0; j < m_size; ++j) {
        const glm::dvec2 up = raised(i, j, m_f.slope(i, j));
        z.value(i, j) = glm::dot(up, steep.slope(i, j));
        z.strength(i, j) = std::sqrt(steep(i, j)) * m_request.featureSize;
        z.u(i, j) = up.x;
        z.v(i, j) = up.y;
      }
    return z;
  }

  Zeros laplacian() const {
    Zeros z(m_size);
    const auto flow = [&](int i, int j) {
      return std::sqrt(metric(i, j)) * raised(i, j, m_f.slope(i, j));
    };
    const Grid x = Grid::made(m_size, [&](int i, int j) { return flow(i, j).x; });
    const Grid y = Grid::made(m_size, [&](int i, int j) { return flow(i, j).y; });
    for (int i = 0; i < m_size; ++i)
      for (int j = 0; j < m_size; ++j) {
        z.value(i, j) = x.slope(i, j).x + y.slope(i, j).y;
        z.strength(i, j) = m_request.featureSize *
                           std::sqrt(glm::dot(m_f.slope(i, j), raised(i, j, m_f.slope(i, j))));
      }
    return z;
  }

  /// Zeros of κr = ⟨∇f, w⟩/|w|², with the sign that its derivative along w must have. The product
  /// is even where w, and with it the direction, vanishes.
  Zeros radial(double sign) const {
    Zeros z(m_size);
    z.value = Grid::made(m_size, [&](int i, int j) {
      return glm::dot(m_f.slope(i, j), coordinates(i, j, m_request.view));
    });
    z.strength = Grid::made(m_size, [&](int i, int j) {
      const double across = std::max(1.0 - m_f(i, j) * m_f(i, j), 1e-12);
      return sign * m_request.featureSize * m_request.featureSize *
             glm::dot(z.value.slope(i, j), coordinates(i, j, m_request.view)) /
             std::pow(across, 1.5);
    });
    return z;
  }

  /// An orthonormal frame of the tangent plane.
  std::array<glm::dvec3, 2> frame(int i, int j) const {
    const glm::dvec3 a = glm::normalize(glm::dvec3(1.0, 0.0, m_zx(i, j)));
    return {a, glm::cross(normal(i, j), a)};
  }

  /// Returns dn in that frame.
  glm::dmat2 shape(int i, int j) const {
    const std::array<glm::dvec3, 2> e = frame(i, j);
    const glm::dvec2 zx = m_zx.slope(i, j);
    const glm::dvec2 zy = m_zy.slope(i, j);
    glm::dmat2 s(0.0);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const glm::dvec2 p = coordinates(i, j, e[std::size_t(a)]);
        const glm::dvec2 q = coordinates(i, j, e[std::size_t(b)]);
        s[a][b] = -(p.x * (zx.x * q.x + zx.y * q.y) + p.y * (zy.x * q.x + zy.y * q.y)) /
                  std::sqrt(metric(i, j));
      }
    return s;
  }

  /// Returns the unit eigenvector of the symmetric matrix's greater eigenvalue.
  static glm::dvec2 greaterAxis(const glm::dmat2& m) {
    const double angle = 0.5 * std::atan2(2.0 * m[0][1], m[0][0] - m[1][1]);
    return {std::cos(angle), std::sin(angle)};
  }

  glm::dvec2 inCoordinates(int i, int j, const glm::dvec2& framed) const {
    const std::array<glm::dvec3, 2> e = frame(i, j);
    return coordinates(i, j, framed.x * e[0] + framed.y * e[1]);
  }

  Zeros apparent() const {
    Zeros z(m_size);
    Grid q1(m_size);
    for (int i = 0; i < m_size; ++i)
      for (int j = 0; j < m_size; ++j) {
        const std::array<glm::dvec3, 2> e = frame(i, j);
        const glm::dvec2 w(glm::dot(m_request.view, e[0]), glm::dot(m_request.view, e[1]));
        const double size = glm::dot(w, w);
        const double stretch = (1.0 / std::max(m_f(i, j), 0.01) - 1.0) / std::max(size, 1e-12);
        const glm::dmat2 toSurface = glm::dmat2(1.0) + stretch * glm::outerProduct(w, w);
        const glm::dmat2 q = shape(i, j) * toSurface;
        const glm::dmat2 square = glm::transpose(q) * q;
        const glm::dvec2 t1 = greaterAxis(square);
        q1(i, j) = glm::length(q * t1);
        const glm::dvec2 along = inCoordinates(i, j, toSurface * t1);
        z.u(i, j) = along.x;
        z.v(i, j) = along.y;
        z.strength(i, j) = q1(i, j) * m_request.featureSize;
      }
    for (int i = 0; i < m_size; ++i)
      for (int j = 0; j < m_size; ++j)
        z.value(i, j) = glm::dot(q1.slope(i, j), glm::dvec2(z.u(i, j), z.v(i, j)));
    return z;
  }

  Zeros principalHighlight() const {
    Zeros z(m_size);
    for (int i = 0; i < m_size; ++i)
      for (int j = 0; j < m_size; ++j) {
        const glm::dmat2 s = shape(i, j);
        // Squared, its greater eigenvalue is that of the stronger curvature.
        const glm::dvec2 e1 = greaterAxis(s * s);
        const glm::dvec2 along = inCoordinates(i, j, e1);
        const double k1 = glm::dot(e1, s * e1);
        z.u(i, j) = along.x;
        z.v(i, j) = along.y;
        z.value(i, j) = glm::dot(m_f.slope(i, j), along);
        // Its square is compared, but that does not vanish between numbers on either side of 0.
        z.strength(i, j) = k1 * m_request.featureSize;
      }
    return z;
  }

  /// Appends the line in a triangle of the grid, if there is one.
  void appendIn(const Zeros& z, const Corners& corners, std::vector<LineSample>& samples) const {
    std::array<double, 3> value{};
    glm::dvec2 axis(0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [i, j] = std::pair(corners[c].x, corners[c].y);
      const glm::dvec2 own(z.u(i, j), z.v(i, j));
      // Along an axis that points the other way the value has the other sign.
      const double side = glm::dot(own, c == 0 ? own : axis) < 0.0 ? -1.0 : 1.0;
      axis = c == 0 ? own : axis;
      value[c] = (m_request.kind == KnownKind::photic ? 1.0 : side) * z.value(i, j);
    }
    if ((value[0] > 0.0) == (value[1] > 0.0) && (value[1] > 0.0) == (value[2] > 0.0))
      return;
    std::array<glm::dvec2, 2> ends{};
    double strength = 0.0;
    double facing = 1.0;
    glm::dvec2 rise(0.0);
    std::size_t count = 0;
    for (std::size_t c = 0; c < 3 && count < 2; ++c) {
      const std::size_t d = (c + 1) % 3;
      if ((value[c] > 0.0) == (value[d] > 0.0))
        continue;
      const double t = value[c] / (value[c] - value[d]);
      const auto mixed = [&](const Grid& grid) {
        return (1.0 - t) * grid(corners[c].x, corners[c].y) + t * grid(corners[d].x, corners[d].y);
      };
      const glm::dvec2 from = at(corners[c].x, corners[c].y);
      const glm::dvec2 way = at(corners[d].x, corners[d].y) - from;
      ends[count++] = from + t * way;
      rise += (value[d] - value[c]) * way;
      strength += 0.5 * mixed(z.strength);
      facing = std::min(facing, mixed(m_f));
    }
    if (m_request.kind == KnownKind::principalHighlight)
      strength *= strength;
    const bool falls = glm::dot(axis, axis) == 0.0 || glm::dot(rise, axis) < 0.0;
    if (!falls || facing < 0.02 || !(strength > 0.5 * m_request.threshold))
      return;
    const auto lifted = [&](const glm::dvec2& p) {
      return glm::dvec3(p.x, p.y, m_sheet.heightAt(p));
    };
    samples.push_back({.at = lifted(0.5 * (ends[0] + ends[1])),
                       .length = glm::distance(lifted(ends[0]), lifted(ends[1])),
                       .certain = strength > m_request.threshold});
  }

  const KnownSheet& m_sheet;
  const KnownRequest& m_request;
  int m_size;
  Grid m_zx, m_zy;
  Grid m_f;  ///< ⟨n, v⟩
};

}  // namespace

std::vector<LineSample> linesOnGrid(const KnownSheet& sheet, const KnownRequest& request) {
  return SheetInView(sheet, request).lines();
}

}  // namespace sline::test
