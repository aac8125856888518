// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/fill_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/vectors/region_outlines.h"

namespace sline::render {

namespace {

// Pixels of area. Smaller spots of a tone are noise; smaller parts of a fill are specks.
constexpr float smallestSpot = 60.0f;
constexpr float smallestPart = 3.0f;
// Pixels. Regions consist of whole pixels, so their outlines may lie this far off the pixels'
// edges; where one tone changes to the next, a slightly larger error goes unnoticed.
constexpr float partTolerance = 0.75f;
constexpr float spotTolerance = 1.3f;

Colour colourOf(const glm::vec3& colour) {
  const auto channel = [](float value) {
    return std::uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

class ShapeMaker {
 public:
  ShapeMaker(const SeenTones& seen, const PageMapping& page) : m_seen(seen), m_page(page) {}

  /// Adds everything that is seen with a tone, counted from 1, in the range.
  void add(std::size_t first, std::size_t last, const Colour& colour, float opacity) {
    std::vector<std::uint8_t> inside(m_seen.tones.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = m_seen.tones[i] >= first && m_seen.tones[i] <= last;
    VectorShape shape{.path = {}, .colour = colour, .opacity = opacity, .penWidth = 0.0f};
    const bool whole = m_shapes.empty();
    for (Curve& curve : regionOutlines(inside, m_seen.area, whole ? smallestPart : smallestSpot,
                                       whole ? partTolerance : spotTolerance))
      shape.path.push_back(m_page.toPage(std::move(curve)));
    if (!shape.path.empty())
      m_shapes.push_back(std::move(shape));
  }
  std::vector<VectorShape> take() { return std::move(m_shapes); }

 private:
  const SeenTones& m_seen;
  PageMapping m_page;
  std::vector<VectorShape> m_shapes;
};

/// Finds the paint that makes each tone of the one below it: P_k = c·d + P_(k−1)·(1 − d).
class TonePaint {
 public:
  explicit TonePaint(const glm::vec3& paper) : m_paper(paper) {}

  /// Returns colour and opacity of a layer of paint that results in that tone (premultiplied);
  /// nothing where the tone is already there.
  std::optional<glm::vec4> over(const glm::vec4& wanted) {
    float opacity = 1.0f;
    if (wanted.a < 0.99f && m_below.a < 1.0f)
      opacity = 1.0f - (1.0f - wanted.a) / (1.0f - m_below.a);
    // A tone may be denser and yet have less light, but no paint takes light away without covering.
    // It then covers more than it should, and is right on the page's own paper.
    for (int i = 0; i < 3; ++i)
      opacity = std::max(opacity, 1.0f - wanted[i] / std::max(m_below[i], 1e-3f));
    if (!(opacity > 0.002f))
      return std::nullopt;
    opacity = std::min(opacity, 1.0f);
    const glm::vec4 left = m_below * (1.0f - opacity);
    const float dense = left.a + opacity;
    const glm::vec3 light = glm::vec3(wanted) + m_paper * (dense - wanted.a);
    const glm::vec3 colour = glm::clamp((light - glm::vec3(left)) / opacity, 0.0f, 1.0f);
    m_below = left + glm::vec4(colour, 1.0f) * opacity;
    return glm::vec4(colour, opacity);
  }

 private:
  glm::vec3 m_paper;
  glm::vec4 m_below{0.0f};
};

}  // namespace

FillShapes fillShapes(const SeenTones& seen, const glm::vec3& paper, const PageMapping& page) {
  FillShapes result;
  float densest = 0.0f;
  for (const glm::vec4& colour : seen.colours)
    densest = std::max(densest, colour.a);
  if (seen.area.empty() || !(densest > 0.0f))
    return result;
  result.opacity = densest;
  ShapeMaker maker(seen, page);
  TonePaint paint(paper);
  const std::size_t tones = seen.firstCapTone;
  for (std::size_t k = 0; k < tones; ++k)
    if (const std::optional<glm::vec4> tone = paint.over(seen.colours[k] / densest))
      maker.add(k + 1, tones, colourOf(glm::vec3(*tone)), tone->a);
  for (std::size_t cap = tones; cap + 1 < seen.colours.size(); cap += 2) {
    const auto add = [&](std::size_t first, std::size_t last, const glm::vec4& colour) {
      if (colour.a > 0.0f)
        maker.add(first + 1, last + 1, colourOf(glm::vec3(colour) / colour.a), colour.a / densest);
    };
    add(cap, cap + 1, seen.colours[cap]);
    add(cap + 1, cap + 1, seen.colours[cap + 1]);
  }
  result.shapes = maker.take();
  return result;
}

}  // namespace sline::render
