// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/pipe.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace sline::model {

namespace {
/// Describes the lines along the wall of a course, each at its angle around it. Frames are carried
/// along without twist.
class Wall {
 public:
  Wall(const Curve& course, float less) : m_course(course), m_less(less) {
    glm::vec3 side(0.36f, 0.48f, 0.8f);
    for (std::size_t i = 0; i < course.knots().size(); ++i) {
      const glm::vec3 tangent = course.at(float(i)).tangent;
      side = glm::normalize(side - glm::dot(side, tangent) * tangent);
      m_sides.push_back(side);
    }
  }

  glm::vec3 at(float s, float angle) const {
    const Curve::Place place = m_course.at(s);
    const std::size_t i = std::min(std::size_t(s), m_sides.size() - 2);
    const glm::vec3 carried = glm::mix(m_sides[i], m_sides[i + 1], s - float(i));
    const glm::vec3 side =
        glm::normalize(carried - glm::dot(carried, place.tangent) * place.tangent);
    const glm::vec3 up = glm::cross(place.tangent, side);
    return glm::vec3(place.main) +
           (place.main.w - m_less) * (std::cos(angle) * side + std::sin(angle) * up);
  }

  /// Returns where the line at that angle passes through the plane of an end, by bisection.
  float cut(const PipeEnd& end, float angle) const {
    const float middle = nearest(end.point);
    float low = std::max(middle - reach, 0.0f);
    float high = std::min(middle + reach, float(m_sides.size() - 1));
    const auto out = [&](float s) { return glm::dot(at(s, angle) - end.point, end.normal); };
    const bool rising = out(high) > out(low);
    for (int step = 0; step < 24; ++step) {
      const float s = 0.5f * (low + high);
      ((out(s) > 0.0f) == rising ? high : low) = s;
    }
    return 0.5f * (low + high);
  }

 private:
  static constexpr float reach = 4.0f;  // in knots

  float nearest(const glm::vec3& p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < m_sides.size(); ++i)
      if (glm::distance(glm::vec3(m_course.knots()[i].main), p) <
          glm::distance(glm::vec3(m_course.knots()[best].main), p))
        best = i;
    return float(best);
  }

  const Curve& m_course;
  float m_less;
  std::vector<glm::vec3> m_sides;
};

float lengthBetween(const Curve& course, const std::array<PipeEnd, 2>& ends) {
  const Wall axis(course, 0.0f);
  const auto centre = [&](float s) { return glm::vec3(course.at(s).main); };
  const float from = axis.cut(ends[0], 0.0f);
  const float to = axis.cut(ends[1], 0.0f);
  constexpr int steps = 200;
  float length = 0.0f;
  for (int i = 0; i < steps; ++i)
    length += glm::distance(centre(glm::mix(from, to, float(i) / float(steps))),
                            centre(glm::mix(from, to, float(i + 1) / float(steps))));
  return length;
}

/// Returns a grid that closes in both directions, each row shifted half a step from the one before.
std::vector<Triangle> torus(std::size_t rows, std::size_t columns) {
  std::vector<Triangle> triangles;
  const auto index = [&](std::size_t row, std::size_t column) {
    return std::uint32_t(row % rows * columns + column % columns);
  };
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      // Odd rows are ahead of even ones.
      const std::size_t lower = r % 2 == 0 ? 0 : 1;
      const std::size_t upper = 1 - lower;
      triangles.push_back({index(r, c), index(r, c + 1), index(r + 1, c + lower)});
      triangles.push_back({index(r, c + upper), index(r + 1, c + 1), index(r + 1, c)});
    }
  return triangles;
}
}  // namespace

Facets pipe(const Curve& course, float wall, const std::array<PipeEnd, 2>& ends, float edge) {
  float radius = 0.0f;
  for (const Curve::Knot& knot : course.knots())
    radius = std::max(radius, knot.main.w);
  constexpr float turn = 2.0f * std::numbers::pi_v<float>;
  const auto columns = std::size_t(std::max(12.0f, std::ceil(turn * radius / edge)));
  const auto along = std::size_t(std::max(4.0f, std::ceil(lengthBetween(course, ends) / edge)));
  Facets facets;
  // The rows run down the outside and back within; the rows at the ends meet across the wall.
  const Wall outside(course, 0.0f);
  const Wall inside(course, wall);
  const std::size_t rows = 2 * (along + 1);
  facets.positions.resize(rows * columns);
  for (std::size_t half = 0; half < 2 * columns; ++half)
    for (const bool outer : {true, false}) {
      const Wall& side = outer ? outside : inside;
      const float angle = turn * 0.5f * float(half) / float(columns);
      const float from = side.cut(ends[0], angle);
      const float to = side.cut(ends[1], angle);
      const std::size_t first = outer ? 0 : along + 1;
      for (std::size_t r = first; r < first + along + 1; ++r)
        if (r % 2 == half % 2) {
          const float t = float(outer ? r : rows - 1 - r) / float(along);
          facets.positions[r * columns + half / 2] = side.at(glm::mix(from, to, t), angle);
        }
    }
  facets.triangles = torus(rows, columns);
  return facets;
}

}  // namespace sline::model
