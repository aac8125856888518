// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/stroke_spacing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace sline::render {

namespace {
constexpr float mostCellsASide = 128.0f;  // each way
// The least cosine between normals of one sheet.
constexpr float sameSheet = 0.2f;
}  // namespace

StrokeSpacing::StrokeSpacing(float distance, const model::Box& box)
    : m_distance(distance), m_box(box) {
  const glm::vec3 size = glm::clamp(glm::ceil(box.size() / distance), 1.0f, mostCellsASide);
  m_size = {int(size.x), int(size.y), int(size.z)};
  m_first.assign(std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z), -1);
}

StrokeSpacing::Cell StrokeSpacing::cell(const glm::vec3& p) const {
  const glm::vec3 last(float(m_size.x - 1), float(m_size.y - 1), float(m_size.z - 1));
  const glm::vec3 c = glm::clamp((p - m_box.low) / m_distance, glm::vec3(0.0f), last);
  return {int(c.x), int(c.y), int(c.z)};
}

void StrokeSpacing::add(const Mark& mark) {
  if (glm::any(glm::lessThan(mark.position, m_box.low)) ||
      glm::any(glm::greaterThan(mark.position, m_box.high)))
    return;
  std::int32_t& first = m_first[index(cell(mark.position))];
  m_marks.push_back({mark, first});
  first = std::int32_t(m_marks.size()) - 1;
}

void StrokeSpacing::addAlong(const glm::vec3& from, const Mark& to, int pieces) {
  // The shares of the way between which it lies in the box.
  float low = 0.0f;
  float high = 1.0f;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const float way = to.position[axis] - from[axis];
    if (way == 0.0f && (from[axis] < m_box.low[axis] || from[axis] > m_box.high[axis]))
      return;
    if (way == 0.0f)
      continue;
    const float one = (m_box.low[axis] - from[axis]) / way;
    const float other = (m_box.high[axis] - from[axis]) / way;
    low = std::clamp(std::min(one, other), low, 1.0f);
    high = std::clamp(std::max(one, other), 0.0f, high);
  }
  // One more on either side, for the rounding.
  const auto count = float(pieces);
  const int first = std::max(1, int(std::floor(low * count)) - 1);
  const int last = std::min(pieces, int(std::ceil(high * count)) + 1);
  for (int k = first; k <= last; ++k)
    add({glm::mix(from, to.position, float(k) / count), to.normal});
}

float StrokeSpacing::room(const Mark& place) const {
  const Cell low = cell(place.position - m_distance);
  const Cell high = cell(place.position + m_distance);
  float nearest2 = m_distance * m_distance;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        for (std::int32_t i = m_first[index({x, y, z})]; i >= 0; i = m_marks[std::size_t(i)].next) {
          const Mark& mark = m_marks[std::size_t(i)].mark;
          const glm::vec3 apart = place.position - mark.position;
          const float away2 = glm::dot(apart, apart);
          if (away2 < nearest2 && glm::dot(mark.normal, place.normal) > sameSheet)
            nearest2 = away2;
        }
  return std::sqrt(nearest2) / m_distance;
}

}  // namespace sline::render
