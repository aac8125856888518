// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "model/base/parallel.h"
#include "model/base/srgb.h"

namespace sline::render {

namespace {

constexpr std::uint32_t whole = 65535;

/// Holds colour or grey, and alpha last; straight, 16 bits.
struct Pixel {
  std::array<std::uint16_t, 3> colour;
  std::uint16_t alpha;
};

/// Converts from premultiplied colours; the pixel is put on white unless alpha is kept.
Pixel straight(const std::uint16_t* p, bool keepAlpha) {
  const std::uint32_t alpha = p[3];
  if (alpha == whole)
    return {{p[0], p[1], p[2]}, p[3]};
  Pixel pixel{{0, 0, 0}, p[3]};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!keepAlpha)
      pixel.colour[i] = std::uint16_t(std::min<std::uint32_t>(p[i] + (whole - alpha), whole));
    else if (alpha > 0)
      pixel.colour[i] = std::uint16_t(
          std::min<std::uint64_t>((std::uint64_t(p[i]) * whole + alpha / 2) / alpha, whole));
  }
  return pixel;
}

/// Approximates sRGB's curve in 4096 steps with straight lines between them: exact to 1/65535,
/// except near black to 1/4000.
class LightTable {
 public:
  LightTable() {
    for (std::size_t i = 0; i < m_values.size(); ++i)
      m_values[i] = lightFromSrgb(float(i) / float(m_values.size() - 1));
  }
  float operator()(std::uint16_t srgb) const {
    const float at = float(srgb) / float(whole) * float(m_values.size() - 1);
    const auto index = std::min(std::size_t(at), m_values.size() - 2);
    return std::lerp(m_values[index], m_values[index + 1], at - float(index));
  }

 private:
  std::array<float, 4096> m_values{};
};

const LightTable& light() {
  static const LightTable table;
  return table;
}

/// Returns the luminance (ITU-R BT.709) as an sRGB value.
std::uint16_t greyOf(const std::array<std::uint16_t, 3>& colour) {
  if (colour[0] == colour[1] && colour[1] == colour[2])
    return colour[0];
  const float y =
      0.2126f * light()(colour[0]) + 0.7152f * light()(colour[1]) + 0.0722f * light()(colour[2]);
  return std::uint16_t(std::lround(std::clamp(srgbFromLight(y), 0.0f, 1.0f) * float(whole)));
}

/// Packs one row.
class RowPacker {
 public:
  RowPacker(const PixelLayout& layout, bool pureInk) : m_layout(layout), m_pureInk(pureInk) {}

  void pack(const std::uint16_t* rgba, std::byte* out) const {
    for (int x = 0; x < m_layout.width; ++x, rgba += 4) {
      Pixel pixel = straight(rgba, m_layout.hasAlpha());
      if (m_layout.isGrey() || m_pureInk)
        pixel.colour[0] = greyOf(pixel.colour);
      if (m_pureInk) {
        // A pixel half covered by ink is ink, and a half clear one is clear.
        pixel.colour.fill(pixel.colour[0] < 32768 ? 0 : std::uint16_t(whole));
        pixel.alpha = pixel.alpha < 32768 ? 0 : std::uint16_t(whole);
      }
      if (m_layout.bits == 1)
        putBit(pixel.colour[0] >= 32768, x, out);
      else
        out = put(pixel, out);
    }
  }

 private:
  static void putBit(bool white, int x, std::byte* out) {
    std::byte& byte = out[x / 8];
    if (x % 8 == 0)
      byte = std::byte(0);
    if (white)
      byte |= std::byte(0x80 >> (x % 8));
  }

  std::byte* put(const Pixel& pixel, std::byte* out) const {
    for (std::size_t i = 0; i < (m_layout.isGrey() ? 1u : 3u); ++i)
      out = putValue(pixel.colour[i], pixel.alpha, true, out);
    return m_layout.hasAlpha() ? putValue(pixel.alpha, pixel.alpha, false, out) : out;
  }

  std::byte* putValue(std::uint16_t value, std::uint16_t alpha, bool colour, std::byte* out) const {
    if (m_layout.bits == 8) {
      *out = std::byte((std::uint32_t(value) + 128) / 257);
      return out + 1;
    }
    if (m_layout.bits == 16) {
      std::memcpy(out, &value, 2);
      return out + 2;
    }
    // Where the picture stands on white, its alpha does too.
    const float covers = m_layout.hasAlpha() ? float(alpha) / float(whole) : 1.0f;
    const float linear = colour ? light()(value) * covers : covers;
    std::memcpy(out, &linear, 4);
    return out + 4;
  }

  const PixelLayout& m_layout;
  bool m_pureInk;
};

/// Tells whether the piece is whole squares of that side, and these have their places in the rows.
bool fits(const PicturePiece& piece, int side, int top, const PixelRows& rows) {
  const auto inSquares = [side](int pixels) { return pixels >= 0 && pixels % side == 0; };
  const std::size_t values = std::size_t(4) * std::size_t(std::max(piece.width, 0)) *
                             std::size_t(std::max(piece.height, 0));
  return rows.whole() && inSquares(piece.width) && inSquares(piece.height) &&
         inSquares(piece.left) && inSquares(piece.top) && piece.rgba.size() == values &&
         (piece.left + piece.width) / side <= rows.width && piece.top / side >= top &&
         (piece.top + piece.height) / side - top <= rows.height;
}

}  // namespace

PixelRows rowsOf(const Image& image, int top, int count) {
  if (image.rgba.size() != std::size_t(4) * image.width * image.height || top < 0 || count < 0 ||
      count > image.height - top)
    return {};
  PixelRows rows{.width = image.width, .height = count, .rgba = {}};
  const std::size_t values = std::size_t(image.width) * std::size_t(count) * 4;
  const std::uint8_t* from = image.rgba.data() + std::size_t(top) * std::size_t(image.width) * 4;
  rows.rgba.resize(values);
  for (std::size_t i = 0; i < values; i += 4) {
    const std::uint32_t alpha = from[i + 3];
    for (std::size_t c = 0; c < 3; ++c)
      rows.rgba[i + c] = std::uint16_t((from[i + c] * alpha * 257 + 127) / 255);
    rows.rgba[i + 3] = std::uint16_t(257 * alpha);
  }
  return rows;
}

void putAverages(const PicturePiece& piece, int side, int top, PixelRows& rows) {
  if (side < 1 || !fits(piece, side, top, rows))
    return;
  const std::size_t step = std::size_t(piece.width) * 4;
  const auto count = std::uint32_t(side * side);
  parallelFor(std::size_t(piece.height / side), 16, [&](std::size_t y) {
    const std::uint16_t* from = piece.rgba.data() + y * std::size_t(side) * step;
    std::uint16_t* to =
        rows.rgba.data() + ((std::size_t(piece.top / side - top) + y) * std::size_t(rows.width) +
                            std::size_t(piece.left / side)) *
                               4;
    for (int x = 0; x < piece.width / side; ++x, from += 4 * std::ptrdiff_t(side), to += 4) {
      std::array<std::uint32_t, 4> sum{};
      for (int row = 0; row < side; ++row)
        for (int i = 0; i < 4 * side; ++i)
          sum[std::size_t(i % 4)] += from[std::size_t(row) * step + std::size_t(i)];
      for (std::size_t i = 0; i < 4; ++i)
        to[i] = std::uint16_t((sum[i] + count / 2) / count);
    }
  });
}

std::vector<std::byte> packed(const PixelRows& rows, const PixelLayout& layout, bool pureInk) {
  if (!rows.whole() || rows.width != layout.width || (layout.bits == 1 && layout.channels != 1))
    return {};
  std::vector<std::byte> bytes(layout.rowBytes() * std::size_t(rows.height));
  const RowPacker packer(layout, pureInk);
  parallelFor(std::size_t(rows.height), 16, [&](std::size_t y) {
    packer.pack(rows.rgba.data() + y * std::size_t(rows.width) * 4,
                bytes.data() + y * layout.rowBytes());
  });
  return bytes;
}

}  // namespace sline::render
