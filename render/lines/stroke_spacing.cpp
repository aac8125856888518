// SPDX-License-Identifier: Apache-2.0
#include "render/lines/stroke_spacing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
// Shares of the distance: nearer than the first nothing is left, beyond the second all.
constexpr float touching = 0.5f;
constexpr float clear = 1.1f;
// Along a stroke, past its end, others may come nearer than across it: so they join end to end.
constexpr float past = 1.6f;
constexpr int mostCells = 1 << 20;
}  // namespace

StrokeSpacing::StrokeSpacing(float distance, const glm::vec2& low, const glm::vec2& high)
    : m_distance(distance), m_low(low) {
  const glm::vec2 size = glm::max(high - low, glm::vec2(0.0f)) / distance;
  m_columns = std::clamp(int(size.x) + 1, 1, 4096);
  m_rows = std::clamp(int(size.y) + 1, 1, mostCells / m_columns);
  m_first.assign(std::size_t(m_columns) * std::size_t(m_rows), -1);
}

StrokeSpacing::Cell StrokeSpacing::cell(const glm::vec2& at) const {
  const glm::vec2 c = glm::clamp((at - m_low) / m_distance, glm::vec2(0.0f),
                                 glm::vec2(float(m_columns - 1), float(m_rows - 1)));
  return {int(c.x), int(c.y)};
}

void StrokeSpacing::add(const Mark& mark) {
  std::int32_t& first = m_first[index(cell(mark.at))];
  m_marks.push_back({mark, first});
  first = std::int32_t(m_marks.size()) - 1;
}

float StrokeSpacing::room(const Place& place) const {
  const Cell low = cell(place.at - clear * m_distance);
  const Cell high = cell(place.at + clear * m_distance);
  const float squared = clear * clear * m_distance * m_distance;
  float left = 1.0f;
  for (int y = low.row; y <= high.row; ++y)
    for (int x = low.column; x <= high.column; ++x)
      for (std::int32_t i = m_first[index({x, y})]; i >= 0; i = m_marks[std::size_t(i)].next) {
        const Mark& mark = m_marks[std::size_t(i)].mark;
        const glm::vec2 d = place.at - mark.at;
        const float along = glm::dot(d, mark.direction);
        const float away2 = glm::dot(d, d) + (past * past - 1.0f) * along * along;
        if (away2 >= squared)
          continue;
        const glm::vec3 apart = place.position - mark.position;
        if (glm::dot(apart, apart) > place.reachMm * place.reachMm)
          continue;
        const float away = std::sqrt(away2) / m_distance;
        const float free = std::clamp((away - touching) / (clear - touching), 0.0f, 1.0f);
        left = std::min(left, 1.0f - mark.strength * (1.0f - free));
        if (left <= 0.0f)
          return 0.0f;
      }
  return left;
}

}  // namespace sline::render
