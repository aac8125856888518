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
    const bool whole = m_shapes.empty();
    VectorShape shape{.path = outline(first, last, whole ? smallestPart : smallestSpot,
                                      whole ? partTolerance : spotTolerance),
                      .colour = colour,
                      .opacity = opacity,
                      .penWidth = 0.0f};
    if (!shape.path.empty())
      m_shapes.push_back(std::move(shape));
  }
  /// Returns the image within the outline of everything that has a tone of the surface.
  std::optional<VectorTones> tonesOf(const ToneImage& image) const {
    Path edge = outline(1, m_seen.firstCapTone, smallestPart, partTolerance);
    if (edge.empty())
      return std::nullopt;
    const PixelRect& area = image.area;
    const float scale = m_page.mmPerPixel;
    return VectorTones{.image = image.image,
                       .at = m_page.toPage(glm::vec2(area.x, area.top())),
                       .sizeMm = scale * glm::vec2(area.width, area.height),
                       .edge = std::move(edge)};
  }
  std::vector<VectorShape> take() { return std::move(m_shapes); }

 private:
  Path outline(std::size_t first, std::size_t last, float smallest, float tolerance) const {
    std::vector<std::uint8_t> inside(m_seen.tones.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = m_seen.tones[i] >= first && m_seen.tones[i] <= last;
    Path path;
    for (Curve& curve : regionOutlines(inside, m_seen.area, smallest, tolerance))
      path.push_back(m_page.toPage(std::move(curve)));
    return path;
  }

  const SeenTones& m_seen;
  PageMapping m_page;
  std::vector<VectorShape> m_shapes;
};

}  // namespace

FillShapes fillShapes(const SeenTones& seen, const ToneImage& image, const PageMapping& page) {
  FillShapes result;
  float densest = 0.0f;
  for (const glm::vec4& colour : seen.colours)
    densest = std::max(densest, colour.a);
  if (seen.area.empty() || !(densest > 0.0f))
    return result;
  const bool drawn = !image.area.empty();
  if (drawn)
    densest = 1.0f;
  result.opacity = densest;
  ShapeMaker maker(seen, page);
  const std::size_t tones = seen.firstCapTone;
  if (drawn)
    result.tones = maker.tonesOf(image);
  for (std::size_t k = drawn ? tones : 0; k < tones; ++k)
    if (const glm::vec4& tone = seen.colours[k]; tone.a > 0.0f)
      maker.add(k + 1, tones, colourOf(glm::vec3(tone) / tone.a), 1.0f);
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
