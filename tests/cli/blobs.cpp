// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/blobs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sline::test {

namespace {

constexpr double sigma = 2.0;
constexpr int reach = 8;
constexpr float limit = 0.1f;
constexpr std::size_t smallest = 16;

std::array<float, 2 * reach + 1> kernel() {
  std::array<float, 2 * reach + 1> weights{};
  float sum = 0.0f;
  for (int i = -reach; i <= reach; ++i)
    sum += weights[std::size_t(i + reach)] = float(std::exp(-0.5 * i * i / (sigma * sigma)));
  for (float& weight : weights)
    weight /= sum;
  return weights;
}

/// Blurs along x and turns the picture, so that twice blurs it both ways.
std::vector<float> blurredAndTurned(const std::vector<float>& values, int width, int height) {
  const auto weights = kernel();
  std::vector<float> out(values.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      float sum = 0.0f;
      for (int i = -reach; i <= reach; ++i)
        sum +=
            weights[std::size_t(i + reach)] * values[std::size_t(y) * std::size_t(width) +
                                                     std::size_t(std::clamp(x + i, 0, width - 1))];
      out[std::size_t(x) * std::size_t(height) + std::size_t(y)] = sum;
    }
  return out;
}

float onWhite(const unsigned char* pixel, int channel) {
  const float alpha = float(pixel[3]) / 255.0f;
  return alpha * float(pixel[channel]) / 255.0f + 1.0f - alpha;
}

/// Takes one area that touches itself at sides or corners; returns its pixels.
std::size_t takeArea(std::vector<std::uint8_t>& marked, std::size_t start, int width, int height) {
  std::vector<std::size_t> waiting{start};
  std::size_t count = 0;
  marked[start] = 0;
  while (!waiting.empty()) {
    const auto x = int(waiting.back() % std::size_t(width));
    const auto y = int(waiting.back() / std::size_t(width));
    waiting.pop_back();
    ++count;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
        const std::size_t i = std::size_t(v) * std::size_t(width) + std::size_t(u);
        if (marked[i] != 0) {
          marked[i] = 0;
          waiting.push_back(i);
        }
      }
  }
  return count;
}

}  // namespace

Blobs differingBlobs(const Pixels& a, const Pixels& b) {
  Blobs found;
  const std::size_t pixels = std::size_t(a.width) * std::size_t(a.height);
  std::vector<std::uint8_t> marked(pixels);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<float> difference(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
      difference[i] = onWhite(&a.rgba[4 * i], channel) - onWhite(&b.rgba[4 * i], channel);
    difference = blurredAndTurned(difference, a.width, a.height);
    difference = blurredAndTurned(difference, a.height, a.width);
    for (std::size_t i = 0; i < pixels; ++i) {
      found.largest = std::max(found.largest, double(std::abs(difference[i])));
      if (std::abs(difference[i]) > limit)
        marked[i] = 1;
    }
  }
  std::size_t within = 0;
  for (std::size_t i = 0; i < pixels; ++i)
    if (marked[i] != 0)
      if (const std::size_t area = takeArea(marked, i, a.width, a.height); area >= smallest) {
        within += area;
        ++found.count;
      }
  found.share = double(within) / double(pixels);
  return found;
}

}  // namespace sline::test
