// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/roughness.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>

namespace sline::model {

namespace {

using Complex = std::complex<float>;

/// Performs an in-place radix-2 Fourier transform (Cooley and Tukey 1965); the size is a power of
/// two.
void fourierTransform(std::vector<Complex>& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1)
      j ^= bit;
    j |= bit;
    if (i < j)
      std::swap(x[i], x[j]);
  }
  for (std::size_t length = 2; length <= n; length <<= 1) {
    const double angle = -2.0 * std::numbers::pi / double(length);
    std::vector<Complex> turn(length / 2);
    for (std::size_t k = 0; k < turn.size(); ++k)
      turn[k] = Complex(std::polar(1.0, angle * double(k)));
    for (std::size_t i = 0; i < n; i += length)
      for (std::size_t k = 0; k < length / 2; ++k) {
        const Complex u = x[i + k];
        const Complex v = x[i + k + length / 2] * turn[k];
        x[i + k] = u + v;
        x[i + k + length / 2] = u - v;
      }
  }
}

/// Returns Σ exp(2πi·x/period) over the coordinates along one axis.
std::complex<double> wave(std::span<const glm::vec3> positions, int axis, float period) {
  std::complex<double> sum = 0.0;
  for (const glm::vec3& p : positions)
    sum += std::polar(1.0, 2.0 * std::numbers::pi * double(p[axis]) / double(period));
  return sum;
}

/// The power of a wave Σ exp(2πi·x·frequency) over some coordinates along one axis, and how its
/// logarithm changes with the frequency.
struct WaveAt {
  double power = 0.0;
  double gradient = 0.0;
  double bend = 0.0;
};

WaveAt waveAt(std::span<const glm::vec3> positions, int axis, double frequency) {
  constexpr std::size_t samples = 4096;
  const std::size_t stride = 1 + positions.size() / samples;
  // Where coordinates are counted from turns the wave, and leaves its power as it is.
  const double middle = double(positions[positions.size() / 2][axis]);
  std::complex<double> wave = 0.0;
  std::complex<double> first = 0.0;
  std::complex<double> second = 0.0;
  for (std::size_t v = 0; v < positions.size(); v += stride) {
    const double x = 2.0 * std::numbers::pi * (double(positions[v][axis]) - middle);
    const std::complex<double> one = std::polar(1.0, frequency * x);
    wave += one;
    first += x * one;
    second += x * x * one;
  }
  if (!(std::norm(wave) > 0.0))
    return {};
  const std::complex<double> slope = std::complex<double>(0.0, 1.0) * first / wave;
  return {.power = std::norm(wave),
          .gradient = 2.0 * slope.real(),
          .bend = 2.0 * (-second / wave - slope * slope).real()};
}

/// Finds the frequency at which the wave is strongest, 1/mm, near that of k waves in that length.
/// The transform knows k to a half, and nearby the logarithm of the power is bent downwards: there
/// Newton's method finds the top.
double strongestNear(std::span<const glm::vec3> positions, int axis, double k, double length) {
  constexpr int mostSteps = 12;
  const double low = (k - 1.0) / length;
  const double high = (k + 1.0) / length;
  double frequency = k / length;
  WaveAt here = waveAt(positions, axis, frequency);
  if (!(here.bend < 0.0))
    for (double at = k - 0.875; at < k + 1.0; at += 0.25)
      if (const WaveAt other = waveAt(positions, axis, at / length); other.power > here.power) {
        here = other;
        frequency = at / length;
      }
  double strongest = frequency;
  double most = here.power;
  for (int step = 0; step < mostSteps && here.bend < 0.0; ++step) {
    const double before = frequency;
    frequency = std::clamp(frequency - here.gradient / here.bend, low, high);
    here = waveAt(positions, axis, frequency);
    if (here.power > most) {
      most = here.power;
      strongest = frequency;
    }
    if (std::abs(frequency - before) < 1e-8 * frequency)
      break;
  }
  return strongest;
}

struct Period {
  float length = 0.0f;
  float power = 0.0f;
};

/// Returns the strongest period of the coordinates along one axis, between half and twice the mean
/// edge.
Period strongestPeriod(std::span<const glm::vec3> positions, int axis, float meanEdge) {
  float low = positions.front()[axis];
  float high = low;
  for (const glm::vec3& p : positions) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  const float shortest = 0.4f * meanEdge;
  const float longest = 1.6f * meanEdge;
  const float extent = high - low;
  // A few periods must fit, or else the shape itself would be mistaken for one.
  if (!(extent > 3.0f * longest) || extent > 1e5f * meanEdge)
    return {};
  const float bin = 0.25f * shortest;
  const std::size_t bins = std::size_t(extent / bin) + 1;
  const std::size_t size = std::bit_ceil(2 * bins);
  std::vector<Complex> histogram(size);
  for (const glm::vec3& p : positions)
    histogram[std::size_t((p[axis] - low) / bin)] += 1.0f;
  fourierTransform(histogram);
  const float length = bin * float(size);
  const auto periodAt = [&](std::size_t k) { return length / float(k); };
  const std::size_t first = std::size_t(std::ceil(length / longest));
  const std::size_t last = std::min(size / 2 - 1, std::size_t(length / shortest));
  const auto power = [&](std::size_t k) {
    return std::norm(histogram[k]) / float(positions.size());
  };
  Period best;
  for (std::size_t k = first; k <= last; ++k)
    if (power(k) > best.power)
      best = {periodAt(k), power(k)};
  // Marching cubes put vertices on the grid and half-way between, so the double period is that of
  // the grid.
  Period twice;
  for (std::size_t k = first; k <= last; ++k)
    if (std::abs(periodAt(k) - 2.0f * best.length) < 0.05f * best.length && power(k) > twice.power)
      twice = {periodAt(k), power(k)};
  if (twice.power > 0.07f * best.power)
    best.length = twice.length;
  if (best.power > 20.0f) {
    const float k = length / best.length;
    best.length = float(1.0 / strongestNear(positions, axis, double(k), double(length)));
  }
  return best;
}

}  // namespace

float VoxelGrid::stepHeight(const glm::vec3& normal) const {
  return glm::length(normal * spacing);
}

VoxelGrid findVoxelGrid(std::span<const glm::vec3> positions, float meanEdge) {
  VoxelGrid grid;
  if (positions.size() < 100 || !(meanEdge > 0.0f))
    return grid;
  for (int axis = 0; axis < 3; ++axis) {
    const Period period = strongestPeriod(positions, axis, meanEdge);
    grid.spacing[axis] = period.length;
    grid.power[axis] = period.power;
  }
  return grid;
}

bool isGreyValueSurface(std::span<const glm::vec3> positions, const VoxelGrid& grid) {
  glm::vec3 offset(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(grid.spacing[axis] > 0.0f))
      return false;
    offset[axis] =
        float(std::arg(wave(positions, axis, grid.spacing[axis])) * 0.5 / std::numbers::pi);
  }
  std::size_t onEdges = 0;
  std::complex<double> between = 0.0;
  for (const glm::vec3& p : positions) {
    std::array<float, 3> off{};
    for (int axis = 0; axis < 3; ++axis) {
      const float phase = p[axis] / grid.spacing[axis] - offset[axis];
      off[std::size_t(axis)] = phase - std::round(phase);
    }
    std::sort(off.begin(), off.end(), [](float a, float b) { return std::abs(a) < std::abs(b); });
    if (std::abs(off[1]) < 0.03f) {
      ++onEdges;
      between += std::polar(1.0, 2.0 * std::numbers::pi * double(off[2]));
    }
  }
  // On the surface of a label map the third coordinate always lies half-way.
  return double(onEdges) > 0.9 * double(positions.size()) &&
         std::abs(between) < 0.8 * double(onEdges);
}

}  // namespace sline::model
