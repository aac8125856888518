// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/free_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/export/plate/marks.h"

namespace sline::render {

namespace {

/// Millimetres between a mark and what is drawn: more than the halo around its letters.
constexpr float airToAnatomy = 0.7f;
/// By how much places differ that are tried.
constexpr float step = 0.5f;

}  // namespace

FreePlaces::FreePlaces(const glm::vec2& page, std::vector<LabelBox> taken, const SeenArea* drawn)
    : m_page(page), m_taken(std::move(taken)), m_drawn(drawn) {}

bool FreePlaces::free(const LabelBox& box) const {
  const float edge = 0.5f * markMargin;
  if (box.low.x < edge || box.low.y < edge || box.high.x > m_page.x - edge ||
      box.high.y > m_page.y - edge)
    return false;
  if (std::any_of(m_taken.begin(), m_taken.end(),
                  [&](const LabelBox& other) { return overlap(box, other); }))
    return false;
  return !m_drawn || !m_drawn->anyIn(box.grown(airToAnatomy));
}

std::optional<glm::vec2> FreePlaces::shift(const LabelBox& box,
                                           std::span<const glm::vec2> along) const {
  if (free(box))
    return glm::vec2(0.0f);
  const int most = int(std::ceil(std::max(m_page.x, m_page.y) / step));
  for (const glm::vec2& way : along)
    for (int i = 1; m_drawn && i <= most; ++i)
      for (const float sign : {1.0f, -1.0f}) {
        const glm::vec2 by = sign * float(i) * step * way;
        if (free({box.low + by, box.high + by}))
          return by;
      }
  return std::nullopt;
}

std::optional<glm::vec2> FreePlaces::shiftTogether(const LabelBox& one, const LabelBox& other,
                                                   const glm::vec2& along) const {
  const int most = m_drawn ? int(std::ceil(std::max(m_page.x, m_page.y) / step)) : 0;
  for (int i = 0; i <= most; ++i)
    for (const float sign : {1.0f, -1.0f}) {
      const glm::vec2 by = sign * float(i) * step * along;
      if (free({one.low + by, one.high + by}) && free({other.low + by, other.high + by}))
        return by;
    }
  return std::nullopt;
}

std::optional<glm::vec2> FreePlaces::corner(const glm::vec2& size) const {
  constexpr float margin = markMargin;
  constexpr std::array upAndDown{glm::vec2{0.0f, 1.0f}};
  const glm::vec2 far = m_page - margin - size;
  if (!m_drawn)
    return far;
  for (const glm::vec2& corner :
       {far, glm::vec2{margin, far.y}, glm::vec2{far.x, margin}, glm::vec2{margin, margin}})
    if (const auto by = shift({corner, corner + size}, upAndDown))
      return corner + *by;
  return std::nullopt;
}

LetteringItem movedBy(LetteringItem item, const glm::vec2& by) {
  if (item.text)
    item.text->at += by;
  for (LetteringShape& shape : item.shapes)
    for (Curve& curve : shape.path) {
      curve.start += by;
      for (Cubic& piece : curve.pieces) {
        piece.control1 += by;
        piece.control2 += by;
        piece.end += by;
      }
    }
  return item;
}

}  // namespace sline::render
