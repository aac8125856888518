// SPDX-License-Identifier: Apache-2.0
#include "render/software/blend_row.h"

#include <algorithm>

#include "model/base/wide_loops.h"
#include "render/raster/rounding.h"

namespace sline::render {

namespace {

constexpr std::array<std::uint32_t, TileMask::side> noColours{};
constexpr std::array<std::uint16_t, TileMask::side> noInks{};
constexpr float perByte = 1.0f / 255.0f;

/// The rows that a layer is laid into, from its first pixel on.
struct SumRows {
  float *red, *green, *blue, *opacity;
  float* lines;
  float* depths;
};

/// Notes the depths of what is in sight. Returns in the lowest bit whether there is any, and in the
/// next whether the layer lies anywhere no deeper than what was there before.
SLINE_WIDE_LOOPS int noteDepths(const LayerRow& row, const SumRows& to) {
  const float* depths = row.depths;
  const float* opacity = to.opacity;
  float* before = to.depths;
  int seen = 0;
  int nearer = 0;
  for (std::size_t i = 0; i < row.count; ++i) {
    const int there = int(depths[i] < 1.0f);
    const int here = there & int(opacity[i] <= BlendRow::opaque);
    seen |= here;
    nearer |= there & int(depths[i] <= before[i]);
    before[i] = here != 0 ? depths[i] : before[i];
  }
  return seen | nearer << 1;
}

/// How much of the layer's ink is seen at each pixel, and how much of all that it has.
struct Shares {
  std::array<float, TileMask::side> ink;
  std::array<float, TileMask::side> left;
};

SLINE_WIDE_LOOPS void findShares(const LayerRow& row, const SumRows& to, Shares& shares) {
  const float* depths = row.depths;
  const std::uint16_t* inks = row.inks;
  const float* opacity = to.opacity;
  float* __restrict lines = to.lines;
  float* __restrict coverage = shares.ink.data();
  float* __restrict left = shares.left.data();
  const std::size_t count = row.count;
  for (std::size_t i = 0; i < count; ++i)
    coverage[i] = lines[i] * float(inks[i] & 0xff) * perByte;
  for (std::size_t i = 0; i < count; ++i) {
    const float seen = opacity[i] <= BlendRow::opaque ? 1.0f - opacity[i] * perByte : 0.0f;
    left[i] = depths[i] < 1.0f ? seen : 0.0f;
  }
  if (row.haloed)
    for (std::size_t i = 0; i < count; ++i)
      lines[i] = left[i] > 0.0f && (inks[i] >> 8) > BlendRow::haloAbove ? 0.0f : lines[i];
}

/// One channel of the layer's fill and ink, and of the sums.
struct Channel {
  int shift;  ///< of its bits in a colour
  float ink;
  float* sums;
};

inline void addChannel(const LayerRow& row, const Shares& shares, const Channel& channel) {
  const std::uint32_t* colours = row.colours;
  float* __restrict sums = channel.sums;
  const int shift = channel.shift;
  const float ink = channel.ink;
  const std::size_t count = row.count;
  for (std::size_t i = 0; i < count; ++i) {
    const auto fill = float(std::int32_t((colours[i] >> shift) & 255u));
    sums[i] += shares.left[i] * rule::layered(ink, shares.ink[i], fill);
  }
}

SLINE_WIDE_LOOPS void addColours(const LayerRow& row, const Shares& shares, const SumRows& to) {
  addChannel(row, shares, {0, row.ink.x, to.red});
  addChannel(row, shares, {8, row.ink.y, to.green});
  addChannel(row, shares, {16, row.ink.z, to.blue});
  addChannel(row, shares, {24, 255.0f, to.opacity});
}

/// Returns a channel rounded to the nearest, where the ground shows through.
inline std::uint32_t channelOver(float sum, float ground) {
  return nearestWhole(std::min(sum + ground, 255.0f));
}

/// The sums of all layers.
struct Sums {
  const float *red, *green, *blue, *opacity;
};

SLINE_WIDE_LOOPS void putColours(const Sums& sums, const glm::vec4& ground, std::size_t count,
                                 std::uint32_t* out) {
  const float *red = sums.red, *green = sums.green, *blue = sums.blue, *opacity = sums.opacity;
  const float x = ground.x, y = ground.y, z = ground.z, w = ground.w;
  for (std::size_t i = 0; i < count; ++i) {
    const float left = 1.0f - opacity[i] * perByte;
    out[i] = channelOver(red[i], left * x) | channelOver(green[i], left * y) << 8 |
             channelOver(blue[i], left * z) << 16 | channelOver(opacity[i], left * w) << 24;
  }
}

}  // namespace

void BlendRow::start() {
  for (Values& sums : m_sums)
    sums.fill(0.0f);
  m_lines.fill(1.0f);
  m_depths.fill(-1.0f);
}

bool BlendRow::lay(const LayerRow& row) {
  const auto from = [&](Values& values) { return values.data() + row.first; };
  const SumRows to{from(m_sums[0]), from(m_sums[1]), from(m_sums[2]),
                   from(m_sums[3]), from(m_lines),   from(m_depths)};
  const int found = noteDepths(row, to);
  if (found > 1)
    return false;
  if (found == 0)
    return true;
  LayerRow whole = row;
  whole.colours = row.colours ? row.colours : noColours.data();
  whole.inks = row.inks ? row.inks : noInks.data();
  Shares shares;
  findShares(whole, to, shares);
  addColours(whole, shares, to);
  return true;
}

void BlendRow::finish(const glm::vec4& ground, std::size_t count, std::uint32_t* out) const {
  putColours({m_sums[0].data(), m_sums[1].data(), m_sums[2].data(), m_sums[3].data()}, ground,
             count, out);
}

}  // namespace sline::render
