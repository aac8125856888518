// SPDX-License-Identifier: Apache-2.0
#include "render/measures/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "model/base/srgb.h"

namespace sline::render {

namespace {

const std::uint8_t* pixel(const Image& image, int x, int y) {
  return image.rgba.data() + 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
}

std::array<float, 256> linearLight() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = lightFromSrgb(float(i) / 255.0f);
  }
  return table;
}

template <class Value>
PixelValues valuesOf(const Image& image, const PixelRect& area, const Value& value) {
  PixelValues result{.width = area.width, .height = area.height, .values = {}};
  result.values.reserve(std::size_t(area.width) * std::size_t(area.height));
  for (int y = area.y; y < area.top(); ++y)
    for (int x = area.x; x < area.right(); ++x)
      result.values.push_back(value(pixel(image, x, y)));
  return result;
}

template <class Counts>
PixelRect areaOf(const Image& image, const Counts& counts) {
  int left = image.width;
  int right = 0;
  int first = image.height;
  int last = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (counts(pixel(image, x, y))) {
        left = std::min(left, x);
        right = std::max(right, x + 1);
        first = std::min(first, y);
        last = std::max(last, y + 1);
      }
  return left < right ? PixelRect{left, first, right - left, last - first} : PixelRect{};
}

bool covered(const std::uint8_t* p) {
  return p[3] >= 128;
}

/// Sums over 2·radius + 1 values in a row, those beyond its ends taken as 0.
void boxRow(float* values, std::size_t count, std::size_t stride, int radius,
            std::vector<float>& sums) {
  sums.assign(count + 1, 0.0f);
  for (std::size_t i = 0; i < count; ++i)
    sums[i + 1] = sums[i] + values[i * stride];
  const std::size_t r = std::size_t(radius);
  for (std::size_t i = 0; i < count; ++i)
    values[i * stride] = sums[std::min(i + r + 1, count)] - sums[i - std::min(i, r)];
}

}  // namespace

double meanDifference(const Image& a, const Image& b, const PixelRect& area) {
  std::uint64_t sum = 0;
  for (int y = area.y; y < area.top(); ++y) {
    const std::uint8_t* p = pixel(a, area.x, y);
    const std::uint8_t* q = pixel(b, area.x, y);
    for (int x = 0; x < area.width; ++x, p += 4, q += 4)
      for (int c = 0; c < 3; ++c)
        sum += std::uint64_t(std::abs(int(p[c]) - int(q[c])));
  }
  return double(sum) / (255.0 * 3.0 * double(area.width) * double(area.height));
}

PixelValues luminance(const Image& image, const PixelRect& area) {
  const std::array<float, 256> light = linearLight();
  return valuesOf(image, area, [&](const std::uint8_t* p) {
    return 0.2126f * light[p[0]] + 0.7152f * light[p[1]] + 0.0722f * light[p[2]];
  });
}

PixelValues ink(const Image& image) {
  return valuesOf(image, {0, 0, image.width, image.height},
                  [](const std::uint8_t* p) { return 1.0f - float(p[0] + p[1] + p[2]) / 765.0f; });
}

PixelValues opacity(const Image& image, const PixelRect& area) {
  return valuesOf(image, area, [](const std::uint8_t* p) { return float(p[3]) / 255.0f; });
}

std::size_t PixelMask::count() const {
  return std::accumulate(inside.begin(), inside.end(), std::size_t(0));
}

PixelRect inkedArea(const Image& image) {
  return areaOf(image,
                [](const std::uint8_t* p) { return p[0] < 255 || p[1] < 255 || p[2] < 255; });
}

PixelRect coveredArea(const Image& image) {
  return areaOf(image, covered);
}

PixelMask coveredMask(const Image& image, const PixelRect& area) {
  PixelMask mask{.area = area, .inside = {}};
  for (int y = area.y; y < area.top(); ++y)
    for (int x = area.x; x < area.right(); ++x)
      mask.inside.push_back(covered(pixel(image, x, y)));
  return mask;
}

PixelMask shrunk(const PixelMask& mask, int pixels) {
  PixelMask result = mask;
  const int width = mask.area.width;
  const int height = mask.area.height;
  const auto inside = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height &&
           mask.inside[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool all = true;
      for (int dy = -pixels; dy <= pixels && all; ++dy)
        for (int dx = -pixels; dx <= pixels && all; ++dx)
          all = inside(x + dx, y + dy);
      result.inside[std::size_t(y) * std::size_t(width) + std::size_t(x)] = all;
    }
  return result;
}

double mean(const PixelValues& values, const PixelMask& mask) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    if (mask.inside[i]) {
      sum += values.values[i];
      ++count;
    }
  return count > 0 ? sum / double(count) : 0.0;
}

MaskedBlur::MaskedBlur(const PixelMask& mask, int radius)
    : m_mask(mask), m_radius(radius), m_weight(mask.inside.begin(), mask.inside.end()) {
  box(m_weight);
}

PixelValues MaskedBlur::operator()(const PixelValues& values) const {
  PixelValues result = values;
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] *= float(m_mask.inside[i]);
  box(result.values);
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = m_mask.inside[i] ? result.values[i] / m_weight[i] : 0.0f;
  return result;
}

void MaskedBlur::box(std::vector<float>& values) const {
  const std::size_t width = std::size_t(m_mask.area.width);
  const std::size_t height = std::size_t(m_mask.area.height);
  std::vector<float> sums;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t y = 0; y < height; ++y)
      boxRow(values.data() + y * width, width, 1, m_radius, sums);
    for (std::size_t x = 0; x < width; ++x)
      boxRow(values.data() + x, height, width, m_radius, sums);
  }
}

}  // namespace sline::render
