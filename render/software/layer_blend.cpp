// SPDX-License-Identifier: Apache-2.0
#include "render/software/layer_blend.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "model/base/parallel.h"
#include "model/base/wide_loops.h"
#include "render/sight/rules.h"
#include "render/software/blend_row.h"
#include "render/software/channels.h"

namespace sline::render {

namespace {

/// A layer within a square.
struct Here {
  const BlendLayer* layer;
  Channels ink;          ///< opaque
  float nearest = 1.0f;  ///< its least depth there; 1 where it has nothing
  std::size_t rank = 0;  ///< of layers that lie equally deep the least is in front
  std::array<float, TileMask::side> rows;  ///< its least depth in each row of the square
};

/// A layer at a pixel.
struct Found {
  float depth;
  const Here* here;
  std::size_t at;
};

/// Finds the least of the depths, which are not negative, in each of some rows.
SLINE_WIDE_LOOPS void leastDepths(const float* depths, std::size_t stride, const glm::ivec2& size,
                                  float* rows) {
  const int columns = size.x;
  for (int row = 0; row < size.y; ++row, depths += stride) {
    std::int32_t least = std::bit_cast<std::int32_t>(1.0f);
    for (int i = 0; i < columns; ++i)
      least = std::min(least, std::bit_cast<std::int32_t>(depths[i]));
    rows[row] = std::bit_cast<float>(least);
  }
}

/// Blends squares one by one.
class SquareBlender {
 public:
  SquareBlender(const LayerBlend& what, std::span<std::uint32_t> picture)
      : m_what(what), m_picture(picture), m_background(255.0f * channelsOf(what.background)) {
    m_here.reserve(what.layers.size());
    m_found.resize(what.layers.size() * TileMask::side);
  }

  /// Takes the square's place in the region's grid, and its pixels in the region.
  void blend(int column, int row, const PixelRect& square) {
    const PixelRect pixels{square.x + m_what.region.x, square.y + m_what.region.y, square.width,
                           square.height};
    findLayers(column, row, pixels);
    for (int y = pixels.y; y < pixels.top(); ++y) {
      std::uint32_t* out = m_picture.data() +
                           std::size_t(y - m_what.region.y) * std::size_t(m_what.region.width) +
                           std::size_t(pixels.x - m_what.region.x);
      if (blendInOrder(pixels, y, out))
        continue;
      find(pixels.x, pixels.right(), y);
      for (int i = 0; i < pixels.width; ++i)
        out[i] = colourAt(i, pixels.x + i, y);
    }
  }

 private:
  /// Finds the layers that have something in the square, those that come nearest first.
  void findLayers(int column, int row, const PixelRect& pixels) {
    m_here.clear();
    m_hiding.clear();
    for (std::size_t rank = 0; rank < m_what.layers.size(); ++rank) {
      const BlendLayer& layer = m_what.layers[rank];
      if (!layer.mask->marked(column, row))
        continue;
      const PixelRect shared = intersection(layer.pixels->area, pixels);
      if (shared.empty())
        continue;
      Here here{.layer = &layer,
                .ink = Channels{float(layer.ink.red), float(layer.ink.green), float(layer.ink.blue),
                                255.0f},
                .rank = rank};
      here.rows.fill(1.0f);
      leastDepths(layer.pixels->depths.data() + layer.pixels->at(shared.x, shared.y),
                  std::size_t(layer.pixels->area.width), {shared.width, shared.height},
                  here.rows.data() + (shared.y - pixels.y));
      here.nearest = *std::min_element(here.rows.begin(), here.rows.end());
      if (here.nearest < 1.0f)
        m_here.push_back(here);
      if (layer.hiddenInk)
        m_hiding.push_back(here);
    }
    std::sort(m_here.begin(), m_here.end(), [](const Here& a, const Here& b) {
      return a.nearest < b.nearest || (a.nearest == b.nearest && a.rank < b.rank);
    });
  }

  /// Blends a row where the layers lie, all along it, in the order in which they come nearest.
  /// Returns false otherwise.
  bool blendInOrder(const PixelRect& square, int y, std::uint32_t* out) {
    if (!m_hiding.empty())
      return false;
    m_row.start();
    for (const Here& here : m_here) {
      const BlendLayer& layer = *here.layer;
      const LayerPixels& pixels = *layer.pixels;
      const int first = std::max(square.x, pixels.area.x);
      const int end = std::min(square.right(), pixels.area.right());
      if (!(here.rows[std::size_t(y - square.y)] < 1.0f))
        continue;
      const std::size_t at = pixels.at(first, y);
      if (!m_row.lay({.first = std::size_t(first - square.x),
                      .count = std::size_t(end - first),
                      .depths = pixels.depths.data() + at,
                      .colours = layer.filled ? pixels.colours.data() + at : nullptr,
                      .inks = layer.inked ? pixels.inks.data() + at : nullptr,
                      .ink = {here.ink[0], here.ink[1], here.ink[2]},
                      .haloed = layer.haloed}))
        return false;
    }
    const Channels& ground = m_background;
    m_row.finish({ground[0], ground[1], ground[2], ground[3]}, std::size_t(square.width), out);
    return true;
  }

  std::span<const Found> foundAt(int i) const {
    return {m_found.data() + std::size_t(i) * m_what.layers.size(), m_counts[std::size_t(i)]};
  }

  std::uint32_t colourAt(int i, int x, int y) const {
    const std::span<const Found> found = foundAt(i);
    Channels sum{};
    float lines = 1.0f;  // the share of lines that is left behind the halos of nearer layers
    for (const Found& each : found) {
      sum = wide_rule::laidBehind(sum, sum[3] * (1.0f / 255.0f), layerColour(each, lines));
      if (sum[3] > BlendRow::opaque)
        break;
    }
    const Channels colour = wide_rule::laidBehind(sum, sum[3] * (1.0f / 255.0f), m_background);
    return wordOf(withHiddenLines(colour, x, y));
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
        for (; place > 0 && isBehind(found[place - 1], depth, here.rank); --place)
          found[place] = found[place - 1];
        found[place] = {depth, &here, at + std::size_t(i)};
      }
    }
  }

  static bool isBehind(const Found& found, float depth, std::size_t rank) {
    return rule::liesBefore(depth, float(rank), found.depth, float(found.here->rank));
  }

  static Channels layerColour(const Found& found, float& lines) {
    const BlendLayer& layer = *found.here->layer;
    const Channels colour = layer.filled ? channelsOf(layer.pixels->colours[found.at]) : Channels{};
    const std::uint16_t ink = layer.inked ? layer.pixels->inks[found.at] : std::uint16_t(0);
    if (ink == 0)
      return colour;
    const float coverage = lines * float(ink & 0xff) * (1.0f / 255.0f);
    if (layer.haloed && (ink >> 8) > BlendRow::haloAbove)
      lines = 0.0f;
    return wide_rule::layered(found.here->ink, coverage, colour);
  }

  /// Lays the hidden lines of all layers over the pixel. A line that is seen has the same ink and
  /// covers its own.
  Channels withHiddenLines(Channels colour, int x, int y) const {
    for (const Here& here : m_hiding) {
      const LayerPixels& pixels = *here.layer->pixels;
      const PixelRect& area = pixels.area;
      if (x < area.x || y < area.y || x >= area.right() || y >= area.top())
        continue;
      const float stored = float(pixels.inks[pixels.at(x, y)] >> 8) * (1.0f / 255.0f);
      colour = wide_rule::layered(here.ink, rule::hiddenCoverage(stored), colour);
    }
    return colour;
  }

  const LayerBlend& m_what;
  std::span<std::uint32_t> m_picture;
  Channels m_background;
  BlendRow m_row;
  std::vector<Here> m_here;    ///< that have something in the square, the nearest first
  std::vector<Here> m_hiding;  ///< that have hidden lines, in order
  std::vector<Found> m_found;  ///< as many for each pixel of a row as there are layers
  std::array<std::size_t, TileMask::side> m_counts{};
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
