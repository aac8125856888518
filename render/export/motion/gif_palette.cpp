// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/gif_palette.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sline::render {

namespace {

using Rgb = GifPalette::Rgb;

/// Returns the index of a colour in a cube of that many cells each way.
std::size_t cellOf(const Rgb& colour, std::size_t side) {
  const std::size_t width = 256 / side;
  return (colour[0] / width * side + colour[1] / width) * side + colour[2] / width;
}

/// Holds colours that share 5 bits of each channel.
struct Bin {
  std::array<double, 3> sum{};
  double count = 0.0;
  double at(int channel) const { return sum[std::size_t(channel)] / count; }
};

struct Bins {
  std::vector<Bin> filled;
  Rgb ground{};  ///< the colour that most pixels have, exactly
};

Bins binsOf(std::span<const Image> frames) {
  std::vector<Bin> bins(std::size_t(32) * 32 * 32);
  std::map<Rgb, std::size_t> exact;
  for (const Image& frame : frames)
    for (std::size_t i = 0; i + 3 < frame.rgba.size(); i += 4) {
      if (frame.rgba[i + 3] < 128)
        continue;
      const Rgb c{frame.rgba[i], frame.rgba[i + 1], frame.rgba[i + 2]};
      Bin& bin = bins[cellOf(c, 32)];
      for (std::size_t channel = 0; channel < 3; ++channel)
        bin.sum[channel] += c[channel];
      bin.count += 1.0;
      if (i % 64 == 0)
        ++exact[c];
    }
  Bins result;
  for (const Bin& bin : bins)
    if (bin.count > 0.0)
      result.filled.push_back(bin);
  std::size_t most = 0;
  for (const auto& [colour, count] : exact)
    if (count > most) {
      most = count;
      result.ground = colour;
    }
  return result;
}

/// A run of bins and how much their colours differ from their mean, with pixels counted by their
/// square root: the ground is large, and a small structure's colours count too.
struct Box {
  std::size_t begin = 0;
  std::size_t end = 0;
  int channel = 0;  ///< the channel along which they differ most
  double spread = 0.0;
};

double weightOf(const Bin& bin) {
  return std::sqrt(bin.count);
}

Box measured(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
  Box box{begin, end, 0, 0.0};
  for (int channel = 0; channel < 3; ++channel) {
    double weight = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double w = weightOf(bins[i]);
      weight += w;
      sum += w * bins[i].at(channel);
      squares += w * bins[i].at(channel) * bins[i].at(channel);
    }
    const double spread = squares - sum * sum / weight;
    if (spread > box.spread) {
      box.spread = spread;
      box.channel = channel;
    }
  }
  return box;
}

/// Returns the two parts of a box, cut at its mean.
std::pair<Box, Box> cut(std::vector<Bin>& bins, const Box& box) {
  const auto first = bins.begin() + std::ptrdiff_t(box.begin);
  const auto last = bins.begin() + std::ptrdiff_t(box.end);
  double weight = 0.0;
  double sum = 0.0;
  for (auto bin = first; bin != last; ++bin) {
    weight += weightOf(*bin);
    sum += weightOf(*bin) * bin->at(box.channel);
  }
  auto middle = std::stable_partition(
      first, last, [&](const Bin& bin) { return bin.at(box.channel) <= sum / weight; });
  if (middle == first || middle == last)
    middle = first + (last - first) / 2;
  const auto at = std::size_t(middle - bins.begin());
  return {measured(bins, box.begin, at), measured(bins, at, box.end)};
}

Rgb meanOf(const std::vector<Bin>& bins, const Box& box) {
  Bin all;
  for (std::size_t i = box.begin; i < box.end; ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel)
      all.sum[channel] += bins[i].sum[channel];
    all.count += bins[i].count;
  }
  Rgb mean{};
  for (int channel = 0; channel < 3; ++channel)
    mean[std::size_t(channel)] = std::uint8_t(std::lround(all.at(channel)));
  return mean;
}

int distance(const Rgb& a, const Rgb& b) {
  // Green counts most to the eye, blue least.
  static constexpr std::array<int, 3> weights{3, 6, 1};
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c)
    sum += weights[c] * (int(a[c]) - int(b[c])) * (int(a[c]) - int(b[c]));
  return sum;
}

}  // namespace

GifPalette GifPalette::of(std::span<const Image> frames) {
  GifPalette palette;
  Bins bins = binsOf(frames);
  std::vector<Box> boxes;
  if (!bins.filled.empty())
    boxes.push_back(measured(bins.filled, 0, bins.filled.size()));
  while (!boxes.empty() && boxes.size() < std::size_t(mostColours) - 1) {
    const auto worst = std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
      return (a.end - a.begin > 1 ? a.spread : 0.0) < (b.end - b.begin > 1 ? b.spread : 0.0);
    });
    if (worst->end - worst->begin < 2)
      break;
    const auto [low, high] = cut(bins.filled, *worst);
    *worst = low;
    boxes.push_back(high);
  }
  palette.m_colours.push_back(bins.ground);
  for (const Box& box : boxes)
    if (const Rgb mean = meanOf(bins.filled, box); mean != bins.ground)
      palette.m_colours.push_back(mean);
  palette.m_known.assign(std::size_t(64) * 64 * 64, -1);
  for (std::size_t i = 0; i < palette.m_colours.size(); ++i)
    palette.m_exact.emplace_back(palette.m_colours[i], std::uint8_t(i));
  std::sort(palette.m_exact.begin(), palette.m_exact.end());
  return palette;
}

std::uint8_t GifPalette::nearest(const Rgb& colour) const {
  std::size_t best = 0;
  int least = distance(colour, m_colours[0]);
  for (std::size_t i = 1; i < m_colours.size(); ++i)
    if (const int d = distance(colour, m_colours[i]); d < least) {
      least = d;
      best = i;
    }
  return std::uint8_t(best);
}

std::uint8_t GifPalette::index(const Rgb& colour, int x, int y) {
  if (colour == m_colours.front())
    return 0;
  const auto exact =
      std::lower_bound(m_exact.begin(), m_exact.end(), std::make_pair(colour, std::uint8_t(0)));
  if (exact != m_exact.end() && exact->first == colour)
    return exact->second;
  // Bayer's pattern.
  static constexpr std::array<int, 16> pattern{0, 8,  2, 10, 12, 4, 14, 6,
                                               3, 11, 1, 9,  15, 7, 13, 5};
  const int lift = (pattern[std::size_t(4 * (y % 4) + x % 4)] - 8) / 2;
  Rgb lifted{};
  for (std::size_t c = 0; c < 3; ++c)
    lifted[c] = std::uint8_t(std::clamp(int(colour[c]) + lift, 0, 255));
  std::int16_t& known = m_known[cellOf(lifted, 64)];
  if (known < 0)
    known = nearest(lifted);
  return std::uint8_t(known);
}

}  // namespace sline::render
