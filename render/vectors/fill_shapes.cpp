// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/fill_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/vectors/region_outlines.h"

namespace sline::render {

namespace {

// Pixels by which a fill goes on below what hides it, so that no paper shows between them.
constexpr int underlap = 2;
// Pixels of area. Smaller spots of a tone are noise; smaller parts of a fill, specks.
constexpr float smallestSpot = 24.0f;
constexpr float smallestPart = 3.0f;
// Pixels. Regions come in whole ones: their outlines may lie so far off the pixels' edges.
constexpr float regionTolerance = 0.75f;

/// 1 where the layer has a fill that is seen, and a little beyond.
std::vector<std::uint8_t> seenFill(const DepthLayer& layer, std::size_t index,
                                   const LayerStack& stack) {
  std::vector<std::uint8_t> seen(layer.tones.size());
  for (int y = 0; y < layer.area.height; ++y)
    for (int x = 0; x < layer.area.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(layer.area.width) + std::size_t(x);
      seen[i] = layer.tones[i] > 0 &&
                !stack.hidden(layer.area.x + x, layer.area.y + y, layer.depths[i], index);
    }
  for (int round = 0; round < underlap; ++round) {
    const std::vector<std::uint8_t> before = seen;
    for (int y = 1; y + 1 < layer.area.height; ++y)
      for (int x = 1; x + 1 < layer.area.width; ++x) {
        const std::size_t i = std::size_t(y) * std::size_t(layer.area.width) + std::size_t(x);
        if (layer.tones[i] > 0)
          seen[i] = before[i] | before[i - 1] | before[i + 1] |
                    before[i - std::size_t(layer.area.width)] |
                    before[i + std::size_t(layer.area.width)];
      }
  }
  return seen;
}

Colour colourOf(const glm::vec3& colour) {
  const auto channel = [](float value) {
    return std::uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

class ShapeMaker {
 public:
  ShapeMaker(const DepthLayer& layer, std::vector<std::uint8_t> seen, const PageMapping& page)
      : m_layer(layer), m_seen(std::move(seen)), m_page(page) {}

  /// All that is seen and whose tone, from 1, lies in the range.
  void add(std::size_t first, std::size_t last, const Colour& colour, float opacity) {
    std::vector<std::uint8_t> inside(m_seen.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = m_seen[i] != 0 && m_layer.tones[i] >= first && m_layer.tones[i] <= last;
    VectorShape shape{.path = {}, .colour = colour, .opacity = opacity, .penWidth = 0.0f};
    for (Curve& curve : regionOutlines(
             inside, m_layer.area, m_shapes.empty() ? smallestPart : smallestSpot, regionTolerance))
      shape.path.push_back(m_page.toPage(std::move(curve)));
    if (!shape.path.empty())
      m_shapes.push_back(std::move(shape));
  }
  std::vector<VectorShape> take() { return std::move(m_shapes); }

 private:
  const DepthLayer& m_layer;
  std::vector<std::uint8_t> m_seen;
  PageMapping m_page;
  std::vector<VectorShape> m_shapes;
};

}  // namespace

FillShapes fillShapes(const DepthLayer& layer, std::size_t index, const LayerStack& stack,
                      const PageMapping& page) {
  FillShapes result;
  if (!layer.filled())
    return result;
  float densest = 0.0f;
  for (const glm::vec4& colour : layer.colours)
    densest = std::max(densest, colour.a);
  if (!(densest > 0.0f))
    return result;
  result.opacity = densest;
  ShapeMaker maker(layer, seenFill(layer, index, stack), page);
  // Each tone adds to what lies below it what makes it its own: P_k = c·d + P_(k−1)·(1 − d).
  glm::vec4 below(0.0f);
  const std::size_t tones = layer.firstCapTone;
  for (std::size_t k = 0; k < tones; ++k) {
    const glm::vec4 wanted = layer.colours[k] / densest;
    float opacity = 1.0f;
    if (wanted.a < 0.99f && below.a < 1.0f)
      opacity = std::clamp(1.0f - (1.0f - wanted.a) / (1.0f - below.a), 0.0f, 1.0f);
    if (!(opacity > 0.002f))
      continue;
    const glm::vec3 colour =
        glm::clamp(glm::vec3(wanted - below * (1.0f - opacity)) / opacity, 0.0f, 1.0f);
    maker.add(k + 1, tones, colourOf(colour), opacity);
    below = wanted;
  }
  for (std::size_t cap = tones; cap + 1 < layer.colours.size(); cap += 2) {
    const auto add = [&](std::size_t first, std::size_t last, const glm::vec4& colour) {
      if (colour.a > 0.0f)
        maker.add(first + 1, last + 1, colourOf(glm::vec3(colour) / colour.a), colour.a / densest);
    };
    add(cap, cap + 1, layer.colours[cap]);
    add(cap + 1, cap + 1, layer.colours[cap + 1]);
  }
  result.shapes = maker.take();
  return result;
}

float meanDepth(const DepthLayer& layer) {
  double sum = 0.0;
  std::size_t pixels = 0;
  for (const float depth : layer.depths)
    if (depth < 1.0f) {
      sum += double(depth);
      ++pixels;
    }
  return pixels > 0 ? float(sum / double(pixels)) : 1.0f;
}

}  // namespace sline::render
