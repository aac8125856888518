// SPDX-License-Identifier: Apache-2.0
#include "render/software/layer_pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>

#include "render/raster/rounding.h"
#include "render/software/channels.h"

namespace sline::render {

namespace {

/// Calls `body(first, end, y)` for the rows of the rectangles: places in the area, and the row in
/// the picture.
template <class Body>
void forEachRow(const LayerPixels& pixels, std::span<const PixelRect> rectangles,
                const Body& body) {
  for (const PixelRect& rect : rectangles)
    for (int y = rect.y; y < rect.top(); ++y) {
      const std::size_t first = pixels.at(rect.x, y);
      body(first, first + std::size_t(rect.width), y);
    }
}

template <class Value>
void fillRow(std::vector<Value>& values, std::size_t first, std::size_t end, Value value) {
  std::fill(values.begin() + std::ptrdiff_t(first), values.begin() + std::ptrdiff_t(end), value);
}

/// The samples on two sides of a place, and how far it lies from the first to the second.
struct Between {
  int low, high;
  float t;
};

Between between(int pixel, int corner, int step, int samples) {
  const float at = (float(pixel - corner) + 0.5f) / float(step) - 0.5f;
  const int below = int(std::floor(at));
  return {std::clamp(below, 0, samples - 1), std::clamp(below + 1, 0, samples - 1),
          at - float(below)};
}

}  // namespace

/// Enlarges by mixing the four samples around each pixel.
class SurfaceTaker::Enlarger {
 public:
  explicit Enlarger(LayerPixels& pixels) : m_pixels(pixels) {
    const SampleArea& samples = pixels.samples;
    m_columns.reserve(std::size_t(pixels.area.width));
    for (int x = pixels.area.x; x < pixels.area.right(); ++x)
      m_columns.push_back(between(x, samples.grid.corner.x + pixels.step() * samples.area.x,
                                  pixels.step(), samples.area.width));
    m_ends.resize(m_columns.size());
    for (std::size_t i = m_columns.size(); i-- > 0;) {
      const bool last = i + 1 == m_columns.size() || m_columns[i + 1].low != m_columns[i].low ||
                        m_columns[i + 1].high != m_columns[i].high;
      m_ends[i] = last ? i + 1 : m_ends[i + 1];
    }
  }

  /// What lies between two rows of samples, at each of their columns.
  struct Line {
    std::vector<Channels> colours;
    std::vector<float> depths;
    std::vector<std::uint8_t> covered;  ///< how many of the two samples have the surface
  };

  void row(std::size_t first, std::size_t end, int y, Line& line) const {
    const SampleArea& samples = m_pixels.samples;
    const Between row = between(y, samples.grid.corner.y + m_pixels.step() * samples.area.y,
                                m_pixels.step(), samples.area.height);
    const std::size_t low = std::size_t(row.low) * std::size_t(samples.area.width);
    const std::size_t high = std::size_t(row.high) * std::size_t(samples.area.width);
    const std::size_t begin = m_pixels.at(m_pixels.area.x, y);
    const auto from = std::size_t(m_columns[first - begin].low);
    mixRows({low + from, high + from}, row.t, std::size_t(m_columns[end - 1 - begin].high) - from,
            line);
    for (std::size_t i = first; i < end;) {
      const Between& column = m_columns[i - begin];
      const std::size_t next = std::min(begin + m_ends[i - begin], end);
      const std::size_t left = std::size_t(column.low) - from;
      const std::size_t right = std::size_t(column.high) - from;
      const int covered = line.covered[left] + line.covered[right];
      if (covered == 4)
        mix(i, next, line, left, right);
      else if (covered > 0)
        for (std::size_t at = i; at < next; ++at)
          put(at,
              {low + std::size_t(column.low), low + std::size_t(column.high),
               high + std::size_t(column.low), high + std::size_t(column.high)},
              {m_columns[at - begin].t, row.t});
      i = next;
    }
  }

 private:
  using Corners = std::array<std::size_t, 4>;  ///< samples around a place

  Channels colourOf(std::size_t sample) const {
    return channelsOf(m_pixels.surfaceColours[sample]);
  }
  static Channels mixed(const Channels& a, const Channels& b, float t) { return a + t * (b - a); }

  /// Mixes two rows of samples, from these samples on and to the last column.
  void mixRows(const std::array<std::size_t, 2>& at, float t, std::size_t last, Line& line) const {
    line.colours.resize(last + 1);
    line.depths.resize(last + 1);
    line.covered.resize(last + 1);
    const float* low = m_pixels.surfaceDepths.data() + at[0];
    const float* high = m_pixels.surfaceDepths.data() + at[1];
    for (std::size_t i = 0; i <= last; ++i) {
      line.covered[i] = std::uint8_t(int(low[i] < 1.0f) + int(high[i] < 1.0f));
      if (line.covered[i] < 2)
        continue;
      line.depths[i] = low[i] + t * (high[i] - low[i]);
      line.colours[i] = mixed(colourOf(at[0] + i), colourOf(at[1] + i), t);
    }
  }

  /// Mixes pixels between two columns where all four samples have the surface.
  void mix(std::size_t first, std::size_t end, const Line& line, std::size_t left,
           std::size_t right) const {
    const Channels colour = line.colours[left];
    const Channels colourRise = line.colours[right] - colour;
    const float depth = line.depths[left];
    const float depthRise = line.depths[right] - depth;
    const std::size_t begin = first - (first % std::size_t(m_pixels.area.width));
    for (std::size_t i = first; i < end; ++i) {
      const float across = m_columns[i - begin].t;
      m_pixels.colours[i] = wordOf(colour + across * colourRise);
      m_pixels.depths[i] = depth + across * depthRise;
    }
  }

  void put(std::size_t i, const Corners& at, const glm::vec2& t) const {
    const std::array<float, 4> weights{(1.0f - t.x) * (1.0f - t.y), t.x * (1.0f - t.y),
                                       (1.0f - t.x) * t.y, t.x * t.y};
    float covered = 0.0f;
    float depth = 0.0f;
    Channels colour{};
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (!(m_pixels.surfaceDepths[at[k]] < 1.0f))
        continue;
      covered += weights[k];
      depth += weights[k] * m_pixels.surfaceDepths[at[k]];
      colour += weights[k] * colourOf(at[k]);
    }
    // It fades over one pixel, outside the line between samples that have the surface and those
    // that have not.
    const float share =
        covered > 0.0f ? std::clamp((covered - 0.5f) * float(m_pixels.step()) + 1.5f, 0.0f, 1.0f)
                       : 0.0f;
    if (!(share > 0.0f))
      return;
    m_pixels.colours[i] = wordOf((share / covered) * colour);
    m_pixels.depths[i] = depth / covered;
  }

  LayerPixels& m_pixels;
  std::vector<Between> m_columns;   ///< of the area
  std::vector<std::size_t> m_ends;  ///< of each column, the first after it that has other samples
};

std::uint32_t packedColour(const glm::vec4& colour) {
  std::uint32_t word = 0;
  for (int c = 0; c < 4; ++c)
    word |= nearestWhole(255.0f * std::clamp(colour[c], 0.0f, 1.0f)) << (8 * c);
  return word;
}

void wipeSurface(LayerPixels& pixels, std::span<const PixelRect> rectangles) {
  if (pixels.step() > 1) {
    const PixelRect& samples = pixels.samples.area;
    const std::size_t count = std::size_t(samples.width) * std::size_t(samples.height);
    pixels.surfaceDepths.assign(count, 1.0f);
    pixels.surfaceColours.assign(pixels.filled ? count : 0, 0);
    return;
  }
  const std::size_t count = std::size_t(pixels.area.width) * std::size_t(pixels.area.height);
  pixels.surfaceDepths.resize(count);
  pixels.colours.resize(pixels.filled ? count : 0);
  forEachRow(pixels, rectangles, [&](std::size_t first, std::size_t end, int) {
    fillRow(pixels.surfaceDepths, first, end, 1.0f);
    if (pixels.filled)
      fillRow(pixels.colours, first, end, 0u);
  });
}

void makeRoom(LayerPixels& pixels) {
  const std::size_t count = std::size_t(pixels.area.width) * std::size_t(pixels.area.height);
  pixels.inks.resize(count);
  pixels.depths.resize(count);
  pixels.colours.resize(pixels.filled ? count : 0);
}

void wipe(LayerPixels& pixels, std::span<const PixelRect> rectangles) {
  const bool colours = pixels.filled && pixels.step() > 1;
  forEachRow(pixels, rectangles, [&](std::size_t first, std::size_t end, int) {
    fillRow(pixels.inks, first, end, std::uint16_t(0));
    fillRow(pixels.depths, first, end, 1.0f);
    if (colours)
      fillRow(pixels.colours, first, end, 0u);
  });
}

SurfaceTaker::SurfaceTaker(LayerPixels& pixels)
    : m_pixels(pixels),
      m_enlarger(pixels.step() > 1 ? std::make_unique<const Enlarger>(pixels) : nullptr) {}

SurfaceTaker::~SurfaceTaker() = default;

void SurfaceTaker::take(std::span<const PixelRect> rectangles) const {
  Enlarger::Line line;
  forEachRow(m_pixels, rectangles, [&](std::size_t first, std::size_t end, int y) {
    if (m_enlarger)
      m_enlarger->row(first, end, y, line);
    else
      std::copy_n(m_pixels.surfaceDepths.begin() + std::ptrdiff_t(first),
                  std::ptrdiff_t(end - first), m_pixels.depths.begin() + std::ptrdiff_t(first));
  });
}

}  // namespace sline::render
