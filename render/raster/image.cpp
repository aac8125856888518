// SPDX-License-Identifier: Apache-2.0
#include "render/raster/image.h"

#include <array>
#include <cstddef>

namespace sline::render {

namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// Averages the square that has its first pixel at `corner`, in rows `stride` bytes apart.
Pixel squareAverage(const std::uint8_t* corner, std::size_t stride, int side) {
  std::array<std::uint32_t, 4> sum{};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::uint8_t* p = corner + std::size_t(y) * stride + std::size_t(x) * 4;
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += std::uint32_t(p[i]) * p[3];
      sum[3] += p[3];
    }
  if (sum[3] == 0)
    return {};
  Pixel pixel{};
  for (std::size_t i = 0; i < 3; ++i)
    pixel[i] = std::uint8_t((sum[i] + sum[3] / 2) / sum[3]);
  const auto count = std::uint32_t(side * side);
  pixel[3] = std::uint8_t((sum[3] + count / 2) / count);
  return pixel;
}

}  // namespace

Image averaged(const Image& image, int side) {
  if (side < 1 || image.rgba.size() != std::size_t(4) * image.width * image.height)
    return {};
  Image result{.width = image.width / side, .height = image.height / side, .rgba = {}};
  result.rgba.reserve(std::size_t(result.width) * result.height * 4);
  const std::size_t stride = std::size_t(image.width) * 4;
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const Pixel pixel = squareAverage(
          image.rgba.data() + std::size_t(y) * side * stride + std::size_t(x) * side * 4, stride,
          side);
      result.rgba.insert(result.rgba.end(), pixel.begin(), pixel.end());
    }
  return result;
}

}  // namespace sline::render
