// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/seen_tones.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

namespace sline::render {

namespace {

// Pixels by which a fill continues below what hides it, so that no paper shows between them.
constexpr int underlap = 2;
// Pixels between the places at which the layers in front of a fill are examined.
constexpr int probeStep = 4;
// A fill that is seen more faintly than this is treated as if it were seen this faintly.
constexpr float faintest = 0.02f;

/// Returns 1 where the layer has a fill that is seen, and a little beyond.
std::vector<std::uint8_t> seenFill(const FilledLayer& filled, const LayerStack& stack) {
  const DepthLayer& layer = filled.layer;
  const std::size_t width = std::size_t(layer.area.width);
  std::vector<std::uint8_t> seen(layer.tones.size());
  std::vector<std::uint8_t> below(layer.tones.size());  // pixels hidden by layers painted later
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

/// Returns the tones of what is seen in the smallest rectangle that holds them, within a page of
/// that size.
SeenTones cropped(const DepthLayer& layer, const std::vector<std::uint8_t>& seen,
                  const glm::ivec2& page) {
  constexpr int bleed = 2;  // pixels by which a fill continues beyond the page's edge
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
  SeenTones found{
      .area = {}, .tones = {}, .colours = layer.colours, .firstCapTone = layer.firstCapTone};
  if (low.x >= high.x)
    return found;
  low = glm::max(low - 1, glm::ivec2(0));
  high = glm::min(high + 1, glm::ivec2(layer.area.width, layer.area.height));
  found.area = {layer.area.x + low.x, layer.area.y + low.y, high.x - low.x, high.y - low.y};
  found.tones.reserve(std::size_t(found.area.width) * std::size_t(found.area.height));
  for (int y = low.y; y < high.y; ++y)
    for (int x = low.x; x < high.x; ++x)
      found.tones.push_back(seen[at(x, y)] != 0 ? layer.tones[at(x, y)] : std::uint8_t(0));
  return found;
}

/// Returns the share of a layer's light that is left where it is seen, on average.
float meanTransmittance(const SeenTones& seen, const FilledLayer& filled, const LayerStack& stack) {
  double sum = 0.0;
  std::size_t probes = 0;
  for (int y = 0; y < seen.area.height; y += probeStep)
    for (int x = 0; x < seen.area.width; x += probeStep) {
      const glm::ivec2 pixel(seen.area.x + x, seen.area.y + y);
      const std::ptrdiff_t own = filled.layer.index(pixel.x, pixel.y);
      const std::size_t i = std::size_t(y) * std::size_t(seen.area.width) + std::size_t(x);
      if (seen.tones[i] == 0 || filled.layer.tones[std::size_t(own)] == 0)
        continue;
      sum += double(
          stack.before(glm::vec2(pixel) + 0.5f, filled.layer.depths[std::size_t(own)], filled.index)
              .transmittance);
      ++probes;
    }
  return probes > 0 ? float(sum / double(probes)) : 1.0f;
}

/// Returns, for each tone, the length of the outline around it and all later tones; pixels.
std::vector<double> outlineLengths(const SeenTones& seen) {
  const std::size_t width = std::size_t(seen.area.width);
  std::vector<double> lengths(seen.colours.size(), 0.0);
  const auto step = [&](std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(seen.tones[a], seen.tones[b]);
    for (std::size_t tone = low; tone < high; ++tone)
      ++lengths[tone];
  };
  for (std::size_t i = 0; i < seen.tones.size(); ++i) {
    if (i % width + 1 < width)
      step(i, i + 1);
    if (i + width < seen.tones.size())
      step(i, i + width);
  }
  return lengths;
}

/// Returns how many tones become one where those of a fill without any veil are `atFull`.
std::size_t joined(const SeenTones& seen, double atFull) {
  const double count = atFull / double(std::max(seen.transmittance, faintest));
  return std::max(std::size_t(std::lround(count)), std::size_t(1));
}

}  // namespace

SeenTones seenTones(const FilledLayer& filled, const LayerStack& stack) {
  SeenTones seen = cropped(filled.layer, seenFill(filled, stack), {stack.width(), stack.height()});
  seen.transmittance = meanTransmittance(seen, filled, stack);
  return seen;
}

double outlineLength(const SeenTones& seen) {
  const std::vector<double> lengths = outlineLengths(seen);
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

void joinTones(SeenTones& seen, std::size_t count) {
  const std::size_t tones = seen.firstCapTone;
  if (count <= 1 || tones <= 1)
    return;
  std::vector<double> pixels(seen.colours.size() + 1, 0.0);
  for (const std::uint8_t tone : seen.tones)
    ++pixels[tone];
  std::vector<glm::vec4> colours;
  for (std::size_t first = 0; first < tones; first += count) {
    glm::dvec4 sum(0.0);
    double weight = 0.0;
    for (std::size_t k = first; k < std::min(first + count, tones); ++k) {
      // A tone that is seen nowhere counts almost nothing.
      const double w = pixels[k + 1] + 1e-6;
      sum += w * glm::dvec4(seen.colours[k]);
      weight += w;
    }
    colours.emplace_back(sum / weight);
  }
  const std::size_t left = colours.size();
  colours.insert(colours.end(), seen.colours.begin() + std::ptrdiff_t(tones), seen.colours.end());
  for (std::uint8_t& tone : seen.tones)
    if (tone > tones)
      tone = std::uint8_t(tone - tones + left);
    else if (tone > 0)
      tone = std::uint8_t((tone - 1u) / count + 1u);
  seen.colours = std::move(colours);
  seen.firstCapTone = left;
}

void joinTonesWithin(std::span<SeenTones> all, double mostOutline) {
  std::vector<std::vector<double>> lengths;
  lengths.reserve(all.size());
  for (const SeenTones& seen : all)
    lengths.push_back(outlineLengths(seen));
  const auto lengthWith = [&](double atFull) {
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t count = joined(all[i], atFull);
      for (std::size_t tone = 0; tone < lengths[i].size(); ++tone)
        if (tone >= all[i].firstCapTone || tone % count == 0)
          sum += lengths[i][tone];
    }
    return sum;
  };
  double atFull = 0.5;
  while (atFull < 32.0 && lengthWith(atFull) > mostOutline)
    atFull *= 1.1;
  for (SeenTones& seen : all)
    joinTones(seen, joined(seen, atFull));
}

}  // namespace sline::render
