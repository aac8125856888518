// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/windowed_sinc.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/base/parallel.h"
#include "model/fairing/coarse_rings.h"
#include "model/fairing/wide_vectors.h"

namespace sline::model {

namespace {

constexpr std::size_t grain = 3072;
// Beyond this deviation, in edges, a Gaussian looks at groups of vertices.
constexpr float farthestFine = 8.0f;
// How much longer than edges the ways between groups must be.
constexpr float leastRatio = 1.5f;
// The most steps of a Gaussian; enough for a deviation of 27 edges.
constexpr int mostTerms = 240;

float rootMeanSquareEdge(std::span<const glm::vec3> positions, const VertexRings& rings) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (const std::uint32_t other : rings[v]) {
      const glm::dvec3 way = positions[v] - positions[other];
      sum += glm::dot(way, way);
      ++count;
    }
  return float(std::sqrt(sum / double(std::max<std::size_t>(1, count))));
}

/// Returns the value of the Chebyshev series at k: cos(n·acos(1 − k/2)) is T_n there.
double response(const std::vector<double>& c, double k) {
  const double theta = std::acos(1.0 - 0.5 * k);
  double sum = 0.0;
  for (std::size_t n = 0; n < c.size(); ++n)
    sum += c[n] * std::cos(double(n) * theta);
  return sum;
}

std::vector<double> seriesFor(double cutoff, int iterations) {
  std::vector<double> c(std::size_t(iterations) + 1);
  for (int n = 0; n <= iterations; ++n) {
    const double window = 0.54 + 0.46 * std::cos(std::numbers::pi * n / (iterations + 1));
    c[std::size_t(n)] = window * (n == 0 ? cutoff / std::numbers::pi
                                         : 2.0 * std::sin(n * cutoff) / (n * std::numbers::pi));
  }
  return c;
}

std::vector<double> coefficientsFor(const SincFilter& filter) {
  // The window rounds the step off; moving the cutoff outwards brings the response at the pass band
  // back to 1 (Taubin et al. §4). The response grows with the cutoff there, so bisection finds it.
  const double band = std::acos(1.0 - 0.5 * double(filter.passBand));
  double low = 0.0;
  double high = std::numbers::pi - band;
  for (int i = 0; i < 60; ++i) {
    const double shift = 0.5 * (low + high);
    const bool enough =
        response(seriesFor(band + shift, filter.iterations), double(filter.passBand)) >= 0.995;
    (enough ? high : low) = shift;
  }
  std::vector<double> c = seriesFor(band + high, filter.iterations);
  const double atZero = response(c, 0.0);
  for (double& value : c)
    value /= atZero;
  return c;
}

}  // namespace

std::vector<double> sincCoefficients(const SincFilter& filter) {
  // The coefficients are kept, since all surfaces of a file are smoothed alike and finding the
  // coefficients takes longer than smoothing a small one.
  struct Known {
    SincFilter filter;
    std::vector<double> coefficients;
  };
  thread_local Known last;
  if (last.coefficients.empty() || last.filter != filter)
    last = {filter, coefficientsFor(filter)};
  return last.coefficients;
}

namespace {

/// Returns the sum of the polynomials of those coefficients, applied to the positions.
std::vector<glm::vec3> filtered(std::span<const glm::vec3> positions, const VertexRings& rings,
                                const std::vector<double>& c) {
  const std::size_t count = positions.size();
  // The recurrence is x_0 = x; x_1 = x − K·x/2; x_{n+1} = (2 − K)·x_n − x_{n−1} with K = 1 − mean
  // over the ring.
  std::vector<glm::vec4> before = widened(positions);
  std::vector<glm::vec4> now(count);
  std::vector<glm::vec4> sum(count);
  const auto isFixed = [&](std::size_t v) { return rings.onBorder(v) || rings[v].empty(); };
  parallelFor(count, grain, [&](std::size_t v) {
    now[v] = isFixed(v) ? before[v] : 0.5f * (before[v] + ringMean(before, rings[v]));
    sum[v] = float(c[0]) * before[v] + float(c[1]) * now[v];
  });
  for (std::size_t n = 2; n < c.size(); ++n) {
    const float weight = float(c[n]);
    parallelFor(count, grain, [&](std::size_t v) {
      const glm::vec4 next = isFixed(v) ? now[v] : now[v] + ringMean(now, rings[v]) - before[v];
      before[v] = next;
      sum[v] += weight * next;
    });
    std::swap(before, now);
  }
  std::vector<glm::vec3> result = narrowed(sum);
  for (std::size_t v = 0; v < count; ++v)
    if (isFixed(v))
      result[v] = positions[v];
  return result;
}

template <class Value>
void averaged(std::vector<Value>& values, const VertexRings& rings, int times) {
  std::vector<Value> next(values.size());
  for (int i = 0; i < times; ++i) {
    parallelFor(values.size(), grain, [&](std::size_t v) {
      Value total = values[v];
      for (const std::uint32_t other : rings[v])
        total += values[other];
      next[v] = total / float(1 + rings[v].size());
    });
    std::swap(values, next);
  }
}

}  // namespace

std::vector<glm::vec3> windowedSinc(std::span<const glm::vec3> positions, const VertexRings& rings,
                                    const SincFilter& filter) {
  return filtered(positions, rings, sincCoefficients(filter));
}

std::vector<double> gaussianCoefficients(float deviation) {
  // A step of averaging over rings adds half a squared edge to the variance along each axis, so the
  // Gaussian is exp(−2σ²k); with k = 2 (1 − cos θ) its Chebyshev series is a Fourier series, of
  // which the terms beyond some 4 √(4σ²) vanish.
  const double spread = 4.0 * double(deviation) * double(deviation);
  const int terms = std::clamp(int(std::ceil(4.3 * std::sqrt(spread))) + 6, 8, mostTerms);
  constexpr int samples = 2048;
  std::vector<double> c(std::size_t(terms) + 1, 0.0);
  double total = 0.0;
  for (int n = 0; n <= terms; ++n) {
    for (int i = 0; i < samples; ++i) {
      const double theta = std::numbers::pi * (i + 0.5) / samples;
      c[std::size_t(n)] += std::exp(-spread * (1.0 - std::cos(theta))) * std::cos(n * theta);
    }
    c[std::size_t(n)] *= (n == 0 ? 1.0 : 2.0) / samples;
    total += c[std::size_t(n)];
  }
  for (double& value : c)
    value /= total;
  return c;
}

std::vector<glm::vec3> gaussian(std::span<const glm::vec3> positions, const VertexRings& rings,
                                float deviation) {
  if (!(deviation > farthestFine))
    return filtered(positions, rings, gaussianCoefficients(deviation));
  const CoarseRings coarse(rings);
  const std::vector<glm::vec3> means = coarse.means(positions);
  const float edge = std::max(rings.meanEdge(positions), 1e-20f);
  const float ratio = rootMeanSquareEdge(means, coarse.rings()) / edge;
  // Nothing is gained where vertices do not gather, or have no neighbours.
  if (!(ratio > leastRatio))
    return filtered(positions, rings, gaussianCoefficients(deviation));
  // Means over groups widen the Gaussian twice, once when they are made and once when all vertices
  // of a group take theirs. A last Gaussian as wide as groups lie apart smooths what is left of
  // them: a wave of that length keeps e^(−2π²) of its height.
  const auto groups = coarse.groups();
  double apart = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::dvec3 way = positions[v] - means[groups[v]];
    apart += glm::dot(way, way);
  }
  // Along each of the surface's two axes, in squared edges.
  const double within = apart / (2.0 * double(positions.size()) * double(edge) * double(edge));
  const double rest =
      double(deviation) * double(deviation) - double(ratio) * double(ratio) - 2.0 * within;
  const std::vector<glm::vec3> smooth =
      gaussian(means, coarse.rings(), float(std::sqrt(std::max(rest, 0.0)) / double(ratio)));
  std::vector<glm::vec3> spread(positions.size());
  for (std::size_t v = 0; v < spread.size(); ++v)
    spread[v] = rings.onBorder(v) ? positions[v] : smooth[groups[v]];
  return filtered(spread, rings, gaussianCoefficients(ratio));
}

void averageOverRings(std::vector<float>& values, const VertexRings& rings, int times) {
  averaged(values, rings, times);
}

void averageOverRings(std::vector<glm::vec3>& values, const VertexRings& rings, int times) {
  std::vector<glm::vec4> wide = widened(values);
  averaged(wide, rings, times);
  values = narrowed(wide);
}

}  // namespace sline::model
