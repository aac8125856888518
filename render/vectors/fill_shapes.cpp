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
constexpr float smallestSpot = 60.0f;
constexpr float smallestPart = 3.0f;
// Pixels. Regions come in whole ones: their outlines may lie so far off the pixels' edges, and
// where one tone goes over into the next nobody sees a little more.
constexpr float partTolerance = 0.75f;
constexpr float spotTolerance = 1.3f;

/// 1 where the layer has a fill that is seen, and a little beyond.
std::vector<std::uint8_t> seenFill(const FilledLayer& filled, const LayerStack& stack) {
  const DepthLayer& layer = filled.layer;
  const std::size_t width = std::size_t(layer.area.width);
  std::vector<std::uint8_t> seen(layer.tones.size());
  std::vector<std::uint8_t> below(layer.tones.size());  // of what is painted later
  for (int y = 0; y < layer.area.height; ++y)
    for (int x = 0; x < layer.area.width; ++x) {
      const std::size_t i = std::size_t(y) * width + std::size_t(x);
      if (layer.tones[i] == 0)
        continue;
      const std::optional<std::size_t> hider =
          stack.hider(layer.area.x + x, layer.area.y + y, layer.depths[i], filled.index);
      seen[i] = !hider;
      below[i] = hider && filled.ranks[*hider] > filled.ranks[filled.index];
    }
  for (int round = 0; round < underlap; ++round) {
    const std::vector<std::uint8_t> before = seen;
    for (int y = 1; y + 1 < layer.area.height; ++y)
      for (int x = 1; x + 1 < layer.area.width; ++x) {
        const std::size_t i = std::size_t(y) * width + std::size_t(x);
        if (below[i] != 0)
          seen[i] =
              before[i] | before[i - 1] | before[i + 1] | before[i - width] | before[i + width];
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

/// The tones of what is seen, 0 elsewhere, in the smallest rectangle that holds them.
struct SeenTones {
  gpu::Rect area;
  std::vector<std::uint8_t> tones;
};

/// True where some of the fill lets more through than other parts of it.
bool variesInOpacity(const DepthLayer& layer) {
  float low = 1.0f;
  float high = 0.0f;
  for (std::size_t k = 0; k < layer.firstCapTone; ++k) {
    low = std::min(low, layer.colours[k].a);
    high = std::max(high, layer.colours[k].a);
  }
  return high - low > 0.02f;
}

/// Lets tones go on beyond the structure's own edge, below its contour. The densest tone is a thin
/// rim there, and what outlines cut off of it would show the lightest below.
void widenRim(SeenTones& seen, const DepthLayer& layer, int rimGrowth) {
  const std::size_t width = std::size_t(seen.area.width);
  for (int round = 0; round < rimGrowth; ++round) {
    const std::vector<std::uint8_t> before = seen.tones;
    for (int y = 1; y + 1 < seen.area.height; ++y)
      for (int x = 1; x + 1 < seen.area.width; ++x) {
        const std::size_t i = std::size_t(y) * width + std::size_t(x);
        const std::ptrdiff_t own = layer.index(seen.area.x + x, seen.area.y + y);
        if (before[i] == 0 && layer.tones[std::size_t(own)] == 0)
          seen.tones[i] = std::max(std::max(before[i - 1], before[i + 1]),
                                   std::max(before[i - width], before[i + width]));
      }
  }
}

/// `page` is the picture's size; what lies beside it is left out.
SeenTones seenTones(const DepthLayer& layer, const std::vector<std::uint8_t>& seen,
                    const glm::ivec2& page) {
  constexpr int bleed = 2;  // pixels that a fill goes on beyond the page's edge
  const int rimGrowth = variesInOpacity(layer) ? underlap : 0;
  glm::ivec2 low(layer.area.width, layer.area.height);
  glm::ivec2 high(0);
  const auto at = [&layer](int x, int y) {
    return std::size_t(y) * std::size_t(layer.area.width) + std::size_t(x);
  };
  const glm::ivec2 corner(layer.area.x, layer.area.y);
  const glm::ivec2 first = glm::max(-corner - bleed, glm::ivec2(0));
  const glm::ivec2 last =
      glm::min(page - corner + bleed, glm::ivec2(layer.area.width, layer.area.height));
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x)
      if (seen[at(x, y)] != 0) {
        low = glm::min(low, glm::ivec2(x, y));
        high = glm::max(high, glm::ivec2(x + 1, y + 1));
      }
  SeenTones found;
  if (low.x >= high.x)
    return found;
  low = glm::max(low - rimGrowth - 1, glm::ivec2(0));
  high = glm::min(high + rimGrowth + 1, glm::ivec2(layer.area.width, layer.area.height));
  found.area = {layer.area.x + low.x, layer.area.y + low.y, high.x - low.x, high.y - low.y};
  found.tones.reserve(std::size_t(found.area.width) * std::size_t(found.area.height));
  for (int y = low.y; y < high.y; ++y)
    for (int x = low.x; x < high.x; ++x)
      found.tones.push_back(seen[at(x, y)] != 0 ? layer.tones[at(x, y)] : std::uint8_t(0));
  widenRim(found, layer, rimGrowth);
  return found;
}

class ShapeMaker {
 public:
  ShapeMaker(SeenTones seen, const PageMapping& page) : m_seen(std::move(seen)), m_page(page) {}

  /// All that is seen and whose tone, from 1, lies in the range.
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
  SeenTones m_seen;
  PageMapping m_page;
  std::vector<VectorShape> m_shapes;
};

/// Finds the paint that makes each tone of what lies below it: P_k = c·d + P_(k−1)·(1 − d).
class TonePaint {
 public:
  explicit TonePaint(const glm::vec3& paper) : m_paper(paper) {}

  /// Colour and opacity of a layer of paint after which there is that tone (premultiplied); nothing
  /// where it is there already.
  std::optional<glm::vec4> over(const glm::vec4& wanted) {
    float opacity = 1.0f;
    if (wanted.a < 0.99f && m_below.a < 1.0f)
      opacity = 1.0f - (1.0f - wanted.a) / (1.0f - m_below.a);
    // A tone may be denser and yet have less light: no paint takes light away without covering.
    // Then it covers more than it should, and is right on the page's own paper.
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

FillShapes fillShapes(const FilledLayer& filled, const LayerStack& stack, const PageMapping& page) {
  const DepthLayer& layer = filled.layer;
  FillShapes result;
  if (!layer.filled())
    return result;
  float densest = 0.0f;
  for (const glm::vec4& colour : layer.colours)
    densest = std::max(densest, colour.a);
  if (!(densest > 0.0f))
    return result;
  result.opacity = densest;
  ShapeMaker maker(seenTones(layer, seenFill(filled, stack), {stack.width(), stack.height()}),
                   page);
  TonePaint paint(filled.paper);
  const std::size_t tones = layer.firstCapTone;
  for (std::size_t k = 0; k < tones; ++k)
    if (const std::optional<glm::vec4> tone = paint.over(layer.colours[k] / densest))
      maker.add(k + 1, tones, colourOf(glm::vec3(*tone)), tone->a);
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
