// SPDX-License-Identifier: Apache-2.0
#include "render/software/layer_blend.h"

#include <algorithm>
#include <array>
#include <vector>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

constexpr float hiddenStrength = 0.5f;
// More than this hides all that lies behind.
constexpr float opaque = 0.998f;

glm::vec4 unpacked(std::uint32_t word) {
  return glm::vec4(float(word & 255u), float((word >> 8) & 255u), float((word >> 16) & 255u),
                   float(word >> 24)) *
         (1.0f / 255.0f);
}

/// A layer within a square.
struct Here {
  const BlendLayer* layer;
  glm::vec4 ink;  ///< opaque
};

/// A layer at a pixel.
struct Found {
  float depth;
  const Here* here;
  std::size_t at;
};

/// Blends squares one by one.
class SquareBlender {
 public:
  SquareBlender(const LayerBlend& what, std::span<std::uint32_t> picture)
      : m_what(what), m_picture(picture), m_ground(packedColour(what.background)) {
    m_here.reserve(what.layers.size());
    m_found.resize(what.layers.size() * TileMask::side);
  }

  /// Takes the square's place in the region's grid, and its pixels in the region.
  void blend(int column, int row, const PixelRect& square) {
    m_here.clear();
    m_hidden = false;
    const PixelRect pixels{square.x + m_what.region.x, square.y + m_what.region.y, square.width,
                           square.height};
    for (const BlendLayer& layer : m_what.layers)
      if (layer.mask->marked(column, row) && !intersection(layer.pixels->area, pixels).empty()) {
        const glm::vec3 ink(float(layer.ink.red), float(layer.ink.green), float(layer.ink.blue));
        m_here.push_back({&layer, glm::vec4(ink / 255.0f, 1.0f)});
        m_hidden = m_hidden || layer.hiddenInk;
      }
    for (int y = pixels.y; y < pixels.top(); ++y) {
      std::uint32_t* out = m_picture.data() +
                           std::size_t(y - m_what.region.y) * std::size_t(m_what.region.width) +
                           std::size_t(pixels.x - m_what.region.x);
      find(pixels.x, pixels.right(), y);
      for (int i = 0; i < pixels.width; ++i)
        out[i] = colourAt(i, pixels.x + i, y);
    }
  }

 private:
  std::span<const Found> foundAt(int i) const {
    return {m_found.data() + std::size_t(i) * m_what.layers.size(), m_counts[std::size_t(i)]};
  }

  std::uint32_t colourAt(int i, int x, int y) const {
    const std::span<const Found> found = foundAt(i);
    if (found.empty() && !m_hidden)
      return m_ground;
    // Most often one layer has no ink there and hides all that lies behind it.
    if (!found.empty() && !m_hidden) {
      const BlendLayer& nearest = *found.front().here->layer;
      const std::size_t at = found.front().at;
      if (nearest.filled && nearest.pixels->colours[at] >> 24 == 255 &&
          (nearest.pixels->inks[at] & 0xff) == 0)
        return nearest.pixels->colours[at];
    }
    glm::vec4 sum(0.0f);
    float lines = 1.0f;  // the share of lines that is left behind the halos of nearer layers
    for (const Found& each : found) {
      sum += layerColour(each, lines) * (1.0f - sum.a);
      if (sum.a > opaque)
        break;
    }
    const glm::vec4 colour = sum + m_what.background * (1.0f - sum.a);
    return packedColour(m_hidden ? withHiddenLines(colour, x, y) : colour);
  }

  /// Finds for each pixel of the row the layers that have something there, the nearest first.
  void find(int left, int right, int y) {
    m_counts.fill(0);
    const std::size_t most = m_what.layers.size();
    for (const Here& here : m_here) {
      const LayerPixels& pixels = *here.layer->pixels;
      const PixelRect& area = pixels.area;
      const int first = std::max(left, area.x);
      const int end = std::min(right, area.right());
      if (y < area.y || y >= area.top() || first >= end)
        continue;
      const std::size_t at = pixels.at(first, y);
      const float* depths = pixels.depths.data() + at;
      for (int i = 0; i < end - first; ++i) {
        const float depth = depths[i];
        if (!(depth < 1.0f))
          continue;
        const auto k = std::size_t(first - left) + std::size_t(i);
        Found* found = m_found.data() + k * most;
        std::size_t place = m_counts[k]++;
        for (; place > 0 && found[place - 1].depth > depth; --place)
          found[place] = found[place - 1];
        found[place] = {depth, &here, at + std::size_t(i)};
      }
    }
  }

  static glm::vec4 layerColour(const Found& found, float& lines) {
    const BlendLayer& layer = *found.here->layer;
    glm::vec4 colour = layer.filled ? unpacked(layer.pixels->colours[found.at]) : glm::vec4(0.0f);
    if (!layer.inked)
      return colour;
    const std::uint16_t ink = layer.pixels->inks[found.at];
    if (ink == 0)
      return colour;
    const float coverage = lines * float(ink & 0xff) * (1.0f / 255.0f);
    colour = found.here->ink * coverage + colour * (1.0f - coverage);
    if (layer.haloed && (ink >> 8) > 191)
      lines = 0.0f;
    return colour;
  }

  /// Lays the hidden lines of all layers over the pixel. A line that is seen has the same ink and
  /// covers its own.
  glm::vec4 withHiddenLines(glm::vec4 colour, int x, int y) const {
    for (const Here& here : m_here) {
      const LayerPixels& pixels = *here.layer->pixels;
      const PixelRect& area = pixels.area;
      if (!here.layer->hiddenInk || x < area.x || y < area.y || x >= area.right() ||
          y >= area.top())
        continue;
      const float stored = float(pixels.inks[pixels.at(x, y)] >> 8) * (1.0f / 255.0f);
      const float coverage = stored > 0.75f ? 0.0f : std::min(2.0f * stored, 1.0f) * hiddenStrength;
      colour = here.ink * coverage + colour * (1.0f - coverage);
    }
    return colour;
  }

  const LayerBlend& m_what;
  std::span<std::uint32_t> m_picture;
  std::uint32_t m_ground;
  std::vector<Here> m_here;
  std::vector<Found> m_found;  ///< as many for each pixel of a row as there are layers
  std::array<std::size_t, TileMask::side> m_counts{};
  bool m_hidden = false;  ///< one of them has hidden lines
};

}  // namespace

void blend(const LayerBlend& what, std::span<std::uint32_t> picture) {
  const TileMask& wanted = what.wanted;
  parallelChunks(std::size_t(wanted.rows()), 2, [&](std::size_t begin, std::size_t end) {
    SquareBlender blender(what, picture);
    for (int row = int(begin); row < int(end); ++row)
      for (int column = 0; column < wanted.columns(); ++column)
        if (wanted.marked(column, row))
          blender.blend(column, row, wanted.square(column, row));
  });
}

}  // namespace sline::render
