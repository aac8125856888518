// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/layer_stack.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/sight/rules.h"

namespace sline::render {

namespace {

// This many of the nearest layers before a point count; more than a dozen glazes hide
// everything.
constexpr std::size_t mostLayers = 32;

bool nearerFirst(const SeenFill& a, const SeenFill& b) {
  return rule::liesBefore(a.depth, float(a.layer), b.depth, float(b.layer));
}

// Outlines are looked for on two rings around a pixel.
constexpr std::size_t ringDirections = 12;

std::array<glm::vec2, 2 * ringDirections> ringWays() {
  std::array<glm::vec2, 2 * ringDirections> ways;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const float angle = 6.2831853f * float(k) / float(ringDirections);
    ways[k] = {std::cos(angle), std::sin(angle)};
  }
  return ways;
}

}  // namespace

glm::vec4 laidBehind(const glm::vec4& nearer, const glm::vec4& colour) {
  const auto channel = [&](glm::length_t c) {
    return rule::laidBehind(nearer[c], nearer.a, colour[c]);
  };
  return {channel(0), channel(1), channel(2), channel(3)};
}

LayerStack::LayerStack(std::span<const DepthLayer> layers, glm::vec2 size)
    : m_layers(layers),
      m_width(int(size.x)),
      m_height(int(size.y)),
      m_columns(int(size.x) / tileSide + 1),
      m_rows(int(size.y) / tileSide + 1),
      m_tiles(std::size_t(m_columns) * std::size_t(m_rows)) {
  m_blocks.resize(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].halo > 0.0f)
      m_haloed.push_back(i);
    if (layers[i].halo > 0.0f || layers[i].ink > 0.0f)
      m_blocks[i] = blocksOf(layers[i]);
    const PixelRect& area = layers[i].area;
    if (!layers[i].filled() || area.empty())
      continue;
    // Areas may extend beyond the picture; those parts belong to the tiles at its edge.
    const auto tile = [](int pixel, int tiles) {
      return std::clamp(pixel / tileSide, 0, tiles - 1);
    };
    for (int row = tile(area.y, m_rows); row <= tile(area.top() - 1, m_rows); ++row)
      for (int column = tile(area.x, m_columns); column <= tile(area.right() - 1, m_columns);
           ++column)
        m_tiles[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)].push_back(
            std::uint16_t(i));
  }
}

const std::vector<std::uint16_t>& LayerStack::listAt(int x, int y) const {
  const int column = std::clamp(x / tileSide, 0, m_columns - 1);
  const int row = std::clamp(y / tileSide, 0, m_rows - 1);
  return m_tiles[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)];
}

Veil LayerStack::before(const glm::vec2& pixel, float depth, std::size_t own) const {
  const int x = int(std::floor(pixel.x));
  const int y = int(std::floor(pixel.y));
  std::array<SeenFill, mostLayers> fills;
  std::size_t count = 0;
  for (const std::size_t i : listAt(x, y)) {
    const DepthLayer& layer = m_layers[i];
    const std::ptrdiff_t at = i == own ? -1 : layer.index(x, y);
    if (at < 0 || layer.tones[std::size_t(at)] == 0 || count == mostLayers ||
        !rule::liesBefore(layer.depths[std::size_t(at)], float(i), depth, float(own)))
      continue;
    const glm::vec4& colour = layer.colours[std::size_t(layer.tones[std::size_t(at)] - 1)];
    if (colour.a >= rule::hidesAll)
      return {glm::vec3(0.0f), 0.0f};
    fills[count++] = {layer.depths[std::size_t(at)], i, colour};
  }
  std::sort(fills.begin(), fills.begin() + std::ptrdiff_t(count), nearerFirst);
  glm::vec4 sum(0.0f);
  for (std::size_t i = 0; i < count; ++i)
    sum = laidBehind(sum, fills[i].colour);
  if (sum.a >= rule::hidesAll)
    return {glm::vec3(0.0f), 0.0f};
  return {glm::vec3(sum), 1.0f - sum.a};
}

LayerStack::Blocks LayerStack::blocksOf(const DepthLayer& layer) {
  Blocks blocks{.columns = layer.area.width / blockSide + 1,
                .rows = layer.area.height / blockSide + 1,
                .nearest = {}};
  blocks.nearest.assign(std::size_t(blocks.columns) * std::size_t(blocks.rows), 1.0f);
  for (int y = 0; y < layer.area.height; ++y) {
    const float* depths = layer.depths.data() + std::size_t(y) * std::size_t(layer.area.width);
    float* row = blocks.nearest.data() + std::size_t(y / blockSide) * std::size_t(blocks.columns);
    for (int x = 0; x < layer.area.width; ++x)
      row[x / blockSide] = std::min(row[x / blockSide], depths[x]);
  }
  return blocks;
}

bool LayerStack::mayBeNear(std::size_t layer, const glm::vec2& pixel, float depth,
                           float radius) const {
  const Blocks& blocks = m_blocks[layer];
  const PixelRect& area = m_layers[layer].area;
  const auto block = [](float at, int from) {
    return int(std::floor((at - float(from)) / float(blockSide)));
  };
  // One pixel more, as places between pixels belong to one of them.
  const float reach = radius + 1.0f;
  const int left = std::max(block(pixel.x - reach, area.x), 0);
  const int right = std::min(block(pixel.x + reach, area.x), blocks.columns - 1);
  const int low = std::max(block(pixel.y - reach, area.y), 0);
  const int high = std::min(block(pixel.y + reach, area.y), blocks.rows - 1);
  for (int y = low; y <= high; ++y)
    for (int x = left; x <= right; ++x) {
      const float nearest =
          blocks.nearest[std::size_t(y) * std::size_t(blocks.columns) + std::size_t(x)];
      if (nearest < 1.0f && nearest <= depth)
        return true;
    }
  return false;
}

LayerStack::Ring LayerStack::ringOf(std::size_t layer, const LinePlace& line, float radius,
                                    bool surfaces) const {
  const auto& [pixel, depth, own] = line;
  static const std::array<glm::vec2, 2 * ringDirections> ways = ringWays();
  const DepthLayer& other = m_layers[layer];
  Ring ring;
  if (layer == own || !mayBeNear(layer, pixel, depth, radius) || other.depthAt(pixel) < 1.0f)
    return ring;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const glm::vec2 at = pixel + radius * (k < ringDirections ? 1.0f : 0.5f) * ways[k];
    const float there = other.depthAt(at);
    if (!(there < 1.0f))
      continue;
    const float beside = surfaces ? m_layers[own].depthAt(at) : 1.0f;
    ++(rule::liesBefore(there, float(layer), beside < 1.0f ? beside : depth, float(own))
           ? ring.before
           : ring.behind);
  }
  return ring;
}

bool LayerStack::haloed(const glm::vec2& pixel, float depth, std::size_t own) const {
  return std::any_of(m_haloed.begin(), m_haloed.end(), [&](std::size_t i) {
    return ringOf(i, {pixel, depth, own}, m_layers[i].halo, false).before > 0;
  });
}

bool LayerStack::inked(const glm::vec2& pixel, float depth, std::size_t own) const {
  const auto& near = listAt(int(std::floor(pixel.x)), int(std::floor(pixel.y)));
  // Of two surfaces that lie upon each other, only the one that is in front more often hides lines
  // of the other: else each would hide the other's outline.
  return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
    if (!(m_layers[i].ink > 0.0f))
      return false;
    const Ring ring = ringOf(i, {pixel, depth, own}, m_layers[i].ink, true);
    return ring.before > ring.behind || (ring.before > 0 && ring.before == ring.behind && i < own);
  });
}

std::optional<std::size_t> LayerStack::hider(int x, int y, float depth, std::size_t own) const {
  std::optional<std::size_t> nearest;
  float nearestDepth = depth;
  std::size_t before = own;
  for (const std::size_t i : listAt(x, y)) {
    const std::ptrdiff_t at = i == own ? -1 : m_layers[i].index(x, y);
    if (at < 0)
      continue;
    const std::uint8_t tone = m_layers[i].tones[std::size_t(at)];
    const float itsDepth = m_layers[i].depths[std::size_t(at)];
    if (tone == 0 || m_layers[i].colours[std::size_t(tone - 1)].a < rule::hidesAll ||
        !rule::liesBefore(itsDepth, float(i), nearestDepth, float(before)))
      continue;
    nearest = before = i;
    nearestDepth = itsDepth;
  }
  return nearest;
}

void LayerStack::seenAt(int x, int y, std::vector<SeenFill>& fills) const {
  fills.clear();
  for (const std::size_t i : listAt(x, y)) {
    const std::ptrdiff_t at = m_layers[i].index(x, y);
    if (at >= 0 && m_layers[i].tones[std::size_t(at)] > 0)
      fills.push_back({m_layers[i].depths[std::size_t(at)], i,
                       m_layers[i].colours[std::size_t(m_layers[i].tones[std::size_t(at)] - 1)]});
  }
  std::sort(fills.begin(), fills.end(), nearerFirst);
  const auto last = std::find_if(fills.begin(), fills.end(), [](const SeenFill& fill) {
    return fill.colour.a >= rule::hidesAll;
  });
  if (last != fills.end())
    fills.erase(last + 1, fills.end());
}

}  // namespace sline::render
