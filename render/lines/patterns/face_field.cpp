// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/face_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

constexpr float farAway = std::numeric_limits<float>::max();

/// Replaces a row of squared distances by the least of f(q) + (p − q)² over all q, in cells:
/// Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions" (2012), algorithm 1.
class RowTransform {
 public:
  explicit RowTransform(std::size_t length)
      : m_vertex(length), m_start(length + 1), m_row(length) {}

  void operator()(float* row, std::size_t length, std::size_t stride) {
    std::size_t count = 0;
    for (std::size_t q = 0; q < length; ++q) {
      m_row[q] = row[q * stride];
      if (m_row[q] == farAway)
        continue;
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0 && (start = meeting(m_vertex[count - 1], q)) <= m_start[count - 1])
        --count;
      if (count == 0)
        start = -std::numeric_limits<double>::infinity();
      m_vertex[count] = q;
      m_start[count++] = start;
    }
    if (count == 0)
      return;
    std::size_t k = 0;
    for (std::size_t p = 0; p < length; ++p) {
      while (k + 1 < count && m_start[k + 1] < double(p))
        ++k;
      const double d = double(p) - double(m_vertex[k]);
      row[p * stride] = float(d * d + double(m_row[m_vertex[k]]));
    }
  }

 private:
  /// Returns where the parabola over q comes below the one over v < q.
  double meeting(std::size_t v, std::size_t q) const {
    const double dv = double(v);
    const double dq = double(q);
    return (double(m_row[q]) + dq * dq - double(m_row[v]) - dv * dv) / (2.0 * (dq - dv));
  }

  std::vector<std::size_t> m_vertex;
  std::vector<double> m_start;
  std::vector<float> m_row;
};

glm::dvec2 flatten(const model::PlaneAxes& axes, const glm::vec3& p) {
  return {glm::dot(axes.u, glm::dvec3(p)), glm::dot(axes.v, glm::dvec3(p))};
}

}  // namespace

std::optional<PlaneWindow> windowOf(const CutFace& face) {
  if (face.cap.empty())
    return std::nullopt;
  const model::PlaneAxes axes = model::axesOf(face.plane);
  PlaneWindow window{glm::dvec2(std::numeric_limits<double>::max()),
                     glm::dvec2(std::numeric_limits<double>::lowest())};
  for (const glm::vec3& p : face.cap) {
    const glm::dvec2 at = flatten(axes, p);
    window.low = glm::min(window.low, at);
    window.high = glm::max(window.high, at);
  }
  return window;
}

FaceField::FaceField(const CutFace& face, const PlaneWindow& window, double cell) : m_cell(cell) {
  const glm::dvec2 first = glm::floor(window.low / cell) - 1.0;
  const glm::dvec2 last = glm::ceil(window.high / cell) + 1.0;
  m_low = (first + 0.5) * cell;
  m_width = std::ptrdiff_t(last.x - first.x);
  m_height = std::ptrdiff_t(last.y - first.y);
  m_rim.assign(std::size_t(m_width) * std::size_t(m_height), 0.0f);
  fill(face);
  measure();
}

PlaneWindow FaceField::window() const {
  return {m_low - 0.5 * m_cell,
          m_low + m_cell * (glm::dvec2(double(m_width), double(m_height)) - 0.5)};
}

void FaceField::fill(const CutFace& face) {
  const model::PlaneAxes axes = model::axesOf(face.plane);
  for (std::size_t i = 0; i + 2 < face.cap.size(); i += 3) {
    std::array<glm::dvec2, 3> t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = (flatten(axes, face.cap[i + k]) - m_low) / m_cell;
    std::sort(t.begin(), t.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    const auto first = std::max(std::ptrdiff_t(std::ceil(t[0].y)), std::ptrdiff_t(0));
    const auto last = std::min(std::ptrdiff_t(std::floor(t[2].y)), m_height - 1);
    for (std::ptrdiff_t y = first; y <= last; ++y) {
      const auto across = [&](const glm::dvec2& a, const glm::dvec2& b) {
        return b.y > a.y ? glm::mix(a.x, b.x, (double(y) - a.y) / (b.y - a.y)) : b.x;
      };
      const double longest = across(t[0], t[2]);
      const double bent = double(y) < t[1].y ? across(t[0], t[1]) : across(t[1], t[2]);
      const auto from =
          std::max(std::ptrdiff_t(std::ceil(std::min(longest, bent))), std::ptrdiff_t(0));
      const auto to = std::min(std::ptrdiff_t(std::floor(std::max(longest, bent))), m_width - 1);
      for (std::ptrdiff_t x = from; x <= to; ++x)
        m_rim[std::size_t(y * m_width + x)] = farAway;
    }
  }
}

void FaceField::measure() {
  const auto width = std::size_t(m_width);
  const auto height = std::size_t(m_height);
  parallelChunks(width, 64, [&](std::size_t begin, std::size_t end) {
    RowTransform transform(height);
    for (std::size_t x = begin; x < end; ++x)
      transform(m_rim.data() + x, height, width);
  });
  parallelChunks(height, 64, [&](std::size_t begin, std::size_t end) {
    RowTransform transform(width);
    for (std::size_t y = begin; y < end; ++y) {
      float* const row = m_rim.data() + y * width;
      transform(row, width, 1);
      // The rim runs halfway between the last cell inside and the first outside.
      for (std::size_t x = 0; x < width; ++x)
        row[x] = float(m_cell * std::max(0.0, std::sqrt(double(row[x])) - 0.5));
    }
  });
}

double FaceField::rim(const glm::dvec2& p) const {
  const glm::dvec2 at = (p - m_low) / m_cell;
  const glm::dvec2 cell = glm::floor(at);
  const glm::dvec2 t = at - cell;
  const auto x = std::ptrdiff_t(cell.x);
  const auto y = std::ptrdiff_t(cell.y);
  return glm::mix(glm::mix(double(rimOf(x, y)), double(rimOf(x + 1, y)), t.x),
                  glm::mix(double(rimOf(x, y + 1)), double(rimOf(x + 1, y + 1)), t.x), t.y);
}

glm::dvec2 FaceField::inwards(const glm::dvec2& p) const {
  const glm::dvec2 dx(1.5 * m_cell, 0.0);
  const glm::dvec2 dy(0.0, 1.5 * m_cell);
  const glm::dvec2 slope(rim(p + dx) - rim(p - dx), rim(p + dy) - rim(p - dy));
  const double length = glm::length(slope);
  return length > 1e-9 ? slope / length : glm::dvec2(0.0);
}

}  // namespace sline::render
