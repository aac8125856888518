// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/few_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "render/export/encoding/byte_order.h"
#include "render/export/encoding/deflate.h"
#include "render/export/encoding/png_chunk.h"

namespace sline::render {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

struct CountedColour {
  Rgb rgb{};
  double pixels = 0.0;
};

/// Some colours that become one.
struct ColourBox {
  std::span<CountedColour> colours;
  std::array<double, 3> mean{};
  double error = 0.0;  ///< sum of squares, over all pixels, in the widest channel
  std::size_t widest = 0;

  explicit ColourBox(std::span<CountedColour> of) : colours(of) {
    double pixels = 0.0;
    std::array<double, 3> squares{};
    for (const CountedColour& colour : colours) {
      pixels += colour.pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        mean[c] += colour.pixels * colour.rgb[c];
        squares[c] += colour.pixels * colour.rgb[c] * colour.rgb[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      mean[c] /= pixels;
      const double sum = squares[c] - pixels * mean[c] * mean[c];
      if (sum > error) {
        error = sum;
        widest = c;
      }
    }
  }
};

/// Splits the box at its mean; both halves hold something where its error is not 0.
std::array<ColourBox, 2> halves(const ColourBox& box) {
  const auto middle =
      std::partition(box.colours.begin(), box.colours.end(), [&box](const CountedColour& colour) {
        return colour.rgb[box.widest] <= box.mean[box.widest];
      });
  const auto count = std::size_t(middle - box.colours.begin());
  return {ColourBox(box.colours.first(count)), ColourBox(box.colours.subspan(count))};
}

std::vector<ColourBox> boxesOf(std::span<CountedColour> colours, std::size_t most) {
  std::vector<ColourBox> boxes{ColourBox(colours)};
  while (boxes.size() < most) {
    const auto worst =
        std::max_element(boxes.begin(), boxes.end(),
                         [](const ColourBox& a, const ColourBox& b) { return a.error < b.error; });
    if (worst->error < 1.0)
      break;
    const std::array<ColourBox, 2> parts = halves(*worst);
    *worst = parts[0];
    boxes.push_back(parts[1]);
  }
  return boxes;
}

Rgb colourAt(const Image& image, std::size_t pixel) {
  return {image.rgba[4 * pixel], image.rgba[4 * pixel + 1], image.rgba[4 * pixel + 2]};
}

}  // namespace

std::string pngOfFewColours(const Image& image, int colours) {
  const std::size_t pixels = image.rgba.size() / 4;
  std::map<Rgb, double> counts;
  for (std::size_t i = 0; i < pixels; ++i)
    ++counts[colourAt(image, i)];
  std::vector<CountedColour> all;
  all.reserve(counts.size());
  for (const auto& [rgb, count] : counts)
    all.push_back({rgb, count});
  const std::vector<ColourBox> boxes = boxesOf(all, std::size_t(colours));

  std::map<Rgb, char> numbers;
  std::string palette;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    for (const double value : boxes[b].mean)
      palette += char(std::uint8_t(std::lround(value)));
    for (const CountedColour& colour : boxes[b].colours)
      numbers[colour.rgb] = char(std::uint8_t(b));
  }
  std::string rows;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (i % std::size_t(image.width) == 0)
      rows += '\0';  // no filter
    rows += numbers.at(colourAt(image, i));
  }
  const std::string header = bigEndian(std::uint64_t(image.width), 4) +
                             bigEndian(std::uint64_t(image.height), 4) +
                             std::string("\x08\x03\x00\x00\x00", 5);  // eight bits, of a palette
  return std::string(pngSignature) + pngChunk("IHDR", header) + pngSrgbChunks() +
         pngChunk("PLTE", palette) + pngChunk("IDAT", zlibStream(std::as_bytes(std::span(rows)))) +
         pngChunk("IEND", {});
}

}  // namespace sline::render
