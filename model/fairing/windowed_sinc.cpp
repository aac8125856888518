// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/windowed_sinc.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "model/fairing/coarse_rings.h"
#include "model/fairing/wide_vectors.h"

namespace sline::model {

namespace {

// Beyond this deviation, in edges, a Gaussian looks at groups of vertices.
constexpr double farthestFine = 6.0;
// How much longer than edges the ways between groups must be.
constexpr double leastSpacing = 1.5;
// The most steps of a Gaussian; enough for a deviation of 27 edges.
constexpr int mostTerms = 240;

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

enum class Borders { stay, follow };

/// Returns the sum of the polynomials of those coefficients, applied to the values.
template <class Value>
std::vector<Value> filtered(std::vector<Value> before, const VertexRings& rings,
                            const std::vector<double>& c, Borders borders = Borders::stay) {
  const std::size_t count = before.size();
  // The recurrence is x_0 = x; x_1 = x − K·x/2; x_{n+1} = (2 − K)·x_n − x_{n−1} with K = 1 − mean
  // over the ring.
  std::vector<Value> now(count);
  std::vector<Value> sum(count);
  const auto isFixed = [&](std::size_t v, const auto& ring) {
    return ring.empty() || (borders == Borders::stay && rings.onBorder(v));
  };
  rings.forEach([&](std::size_t v, const auto& ring) {
    now[v] = isFixed(v, ring) ? before[v] : 0.5f * (before[v] + ringMean(before, ring));
    sum[v] = float(c[0]) * before[v] + float(c[1]) * now[v];
  });
  for (std::size_t n = 2; n < c.size(); ++n) {
    const float weight = float(c[n]);
    rings.forEach([&](std::size_t v, const auto& ring) {
      const Value next = isFixed(v, ring) ? now[v] : now[v] + ringMean(now, ring) - before[v];
      before[v] = next;
      sum[v] += weight * next;
    });
    std::swap(before, now);
  }
  for (std::size_t v = 0; v < count; ++v)
    if (isFixed(v, rings[v]))
      sum[v] = now[v];
  return sum;
}

template <class Value>
void averaged(std::vector<Value>& values, const VertexRings& rings, int times) {
  std::vector<Value> next(values.size());
  for (int i = 0; i < times; ++i) {
    rings.forEach([&](std::size_t v, const auto& ring) {
      Value total = values[v];
      for (const std::uint32_t other : ring)
        total += values[other];
      next[v] = total / float(1 + ring.size());
    });
    std::swap(values, next);
  }
}

}  // namespace

std::vector<glm::vec3> windowedSinc(std::span<const glm::vec3> positions, const VertexRings& rings,
                                    const SincFilter& filter) {
  return narrowed(filtered(widened(positions), rings, sincCoefficients(filter)));
}

std::vector<double> gaussianCoefficients(float deviation) {
  // A step of averaging over rings adds half a squared edge to the variance along each axis, so the
  // Gaussian is exp(−2σ²k); with k = 2 (1 − cos θ) its Chebyshev series is a Fourier series of
  // modified Bessel functions, I_n(4σ²), of which the terms beyond some 4 √(4σ²) vanish. Backwards
  // their recurrence is stable (J. C. P. Miller), and their sum is known.
  const double spread = 4.0 * double(deviation) * double(deviation);
  const int terms = std::clamp(int(std::ceil(4.3 * std::sqrt(spread))) + 6, 8, mostTerms);
  std::vector<double> c(std::size_t(terms) + 1, 0.0);
  double after = 0.0;
  double now = 1e-300;
  double total = 0.0;
  for (int n = 2 * terms; n >= 0; --n) {
    if (n <= terms) {
      c[std::size_t(n)] = (n == 0 ? 1.0 : 2.0) * now;
      total += c[std::size_t(n)];
    }
    const double before = after + 2.0 * double(n) / std::max(spread, 1e-12) * now;
    after = std::exchange(now, before);
    if (now > 1e200) {
      now *= 1e-250;
      after *= 1e-250;
      total *= 1e-250;
      for (double& value : c)
        value *= 1e-250;
    }
  }
  for (double& value : c)
    value /= total;
  return c;
}

namespace {

/// How far apart groups of vertices lie, in edges.
struct GroupSpacing {
  double apart = 0.0;
  double within = 0.0;  ///< the variance of a group's vertices along each of the surface's two axes
};

GroupSpacing spacingOf(const CoarseRings& coarse, const std::vector<Lanes>& means,
                       const std::vector<Lanes>& positions, const VertexRings& rings) {
  const auto squared = [](const Lanes& a, const Lanes& b) {
    const Lanes way = a - b;
    const glm::dvec3 exact(narrowed(way));
    return glm::dot(exact, exact);
  };
  const auto meanSquaredEdge = [&](const std::vector<Lanes>& at, const VertexRings& along) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < at.size(); ++v)
      for (const std::uint32_t other : along[v]) {
        sum += squared(at[v], at[other]);
        ++count;
      }
    return sum / double(std::max<std::size_t>(1, count));
  };
  const double edge = std::max(meanSquaredEdge(positions, rings), 1e-30);
  double within = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v)
    within += squared(positions[v], means[coarse.groups()[v]]);
  return {std::sqrt(meanSquaredEdge(means, coarse.rings()) / edge),
          within / (2.0 * edge * double(std::max<std::size_t>(1, positions.size())))};
}

/// Returns the values averaged with a Gaussian's weights over the surface of those positions.
template <class Value>
std::vector<Value> averagedFar(const std::vector<Value>& values,
                               const std::vector<Lanes>& positions, const VertexRings& rings,
                               double deviation, Borders borders) {
  if (!(deviation > farthestFine))
    return filtered(values, rings, gaussianCoefficients(float(deviation)), borders);
  const CoarseRings coarse(rings);
  const std::vector<Lanes> places = coarse.means(positions);
  const GroupSpacing spacing = spacingOf(coarse, places, positions, rings);
  // Nothing is gained where vertices do not gather, or have no neighbours.
  if (!(spacing.apart > leastSpacing))
    return filtered(values, rings, gaussianCoefficients(float(deviation)), borders);
  // Means over groups widen the Gaussian twice, once when they are made and once when all vertices
  // of a group take theirs. A last Gaussian as wide as groups lie apart smooths what is left of
  // them: a wave of that length keeps e^(−2π²) of its height.
  const double rest = deviation * deviation - spacing.apart * spacing.apart - 2.0 * spacing.within;
  const std::vector<Value> smooth =
      averagedFar(coarse.means(values), places, coarse.rings(),
                  std::sqrt(std::max(rest, 0.0)) / spacing.apart, borders);
  std::vector<Value> spread(values);
  for (std::size_t v = 0; v < spread.size(); ++v)
    if (borders == Borders::follow || !rings.onBorder(v))
      spread[v] = smooth[coarse.groups()[v]];
  return filtered(std::move(spread), rings, gaussianCoefficients(float(spacing.apart)), borders);
}

}  // namespace

std::vector<glm::vec3> gaussian(std::span<const glm::vec3> positions, const VertexRings& rings,
                                float deviation) {
  const std::vector<Lanes> wide = widened(positions);
  return narrowed(averagedFar(wide, wide, rings, double(deviation), Borders::stay));
}

std::vector<float> gaussian(const std::vector<float>& values, std::span<const glm::vec3> positions,
                            const VertexRings& rings, float deviation) {
  return averagedFar(values, widened(positions), rings, double(deviation), Borders::follow);
}

void averageOverRings(std::vector<float>& values, const VertexRings& rings, int times) {
  averaged(values, rings, times);
}

void averageOverRings(std::vector<glm::vec3>& values, const VertexRings& rings, int times) {
  std::vector<Lanes> wide = widened(values);
  averaged(wide, rings, times);
  values = narrowed(wide);
}

}  // namespace sline::model
