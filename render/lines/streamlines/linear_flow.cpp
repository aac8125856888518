// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/linear_flow.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace sline::render {

namespace {

// Where A changes nothing by more than this within t, the series are exact after so many terms.
constexpr double smallStep = 0.5;
constexpr int terms = 16;
constexpr double negligible = 1e-17;
// Where |qt| is smaller, sinh(qt)/q is taken from its series.
constexpr double smallAngle = 0.1;

/// Returns (exp(λt) − 1)/λ.
double growth(double lambda, double t) {
  return lambda == 0.0 ? t : std::expm1(lambda * t) / lambda;
}

/// Returns ∫₀ᵗ sᵏ·exp(ms) ds for k = 0 … 5.
std::array<double, 6> moments(double m, double t) {
  std::array<double, 6> integral{};
  if (std::abs(m * t) <= smallStep) {
    double power = t;
    for (std::size_t k = 0; k < integral.size(); ++k, power *= t) {
      double term = power;
      for (int n = 0; n < terms; ++n) {
        integral[k] += term / double(int(k) + 1 + n);
        term *= m * t / double(n + 1);
      }
    }
    return integral;
  }
  integral[0] = growth(m, t);
  const double end = std::exp(m * t);
  double power = 1.0;
  for (std::size_t k = 1; k < integral.size(); ++k) {
    power *= t;
    integral[k] = (power * end - double(k) * integral[k - 1]) / m;
  }
  return integral;
}

glm::dvec2 times(const std::array<double, 4>& a, const glm::dvec2& v) {
  return {a[0] * v.x + a[1] * v.y, a[2] * v.x + a[3] * v.y};
}

}  // namespace

LinearFlow::LinearFlow(const glm::dvec2& e1, const glm::dvec2& e2, const glm::dvec2& e3)
    : m_a{e2.x - e1.x, e3.x - e1.x, e2.y - e1.y, e3.y - e1.y},
      m_e(e1),
      m_mean(0.5 * (m_a[0] + m_a[3])),
      m_square(m_mean * m_mean - (m_a[0] * m_a[3] - m_a[1] * m_a[2])),
      m_largest(
          std::max(std::abs(m_a[0]) + std::abs(m_a[1]), std::abs(m_a[2]) + std::abs(m_a[3]))) {}

glm::dvec2 LinearFlow::velocity(const glm::dvec2& at) const {
  return times(m_a, at) + m_e;
}

glm::dvec2 LinearFlow::at(const glm::dvec2& from, double t) const {
  const glm::dvec2 start = velocity(from);
  return from +
         (m_largest * std::abs(t) <= smallStep ? series(start, t) : times(integral(t), start));
}

/// Returns I(t)·v = t·Σ (At)ᵏ/(k + 1)!·v.
glm::dvec2 LinearFlow::series(const glm::dvec2& velocity, double t) const {
  const double ratio = m_largest * std::abs(t);
  glm::dvec2 term = t * velocity;
  glm::dvec2 sum = term;
  double left = ratio;
  for (int k = 2; k < terms && left > negligible; ++k) {
    term = t / double(k) * times(m_a, term);
    sum += term;
    left *= ratio / double(k);
  }
  return sum;
}

LinearFlow::Matrix LinearFlow::combined(double x, double y) const {
  return {x + y * (m_a[0] - m_mean), y * m_a[1], y * m_a[2], x + y * (m_a[3] - m_mean)};
}

/// exp(As) = exp(ms)·(cosh(qs)·I + sinh(qs)/q·(A − m·I)). The integrals of both factors are
/// (g(m + q) ± g(m − q)) over 2 and over 2q, g(λ) = (exp(λt) − 1)/λ, which no singular A makes
/// inexact; where qt is small, they come from the series of both factors. Where q² < 0 the
/// eigenvalues are conjugate.
LinearFlow::Matrix LinearFlow::integral(double t) const {
  if (std::sqrt(std::abs(m_square)) * std::abs(t) < smallAngle) {
    const std::array<double, 6> j = moments(m_mean, t);
    return combined(j[0] + m_square / 2.0 * (j[2] + m_square / 12.0 * j[4]),
                    j[1] + m_square / 6.0 * (j[3] + m_square / 20.0 * j[5]));
  }
  if (m_square > 0.0) {
    const double q = std::sqrt(m_square);
    const double high = growth(m_mean + q, t);
    const double low = growth(m_mean - q, t);
    return combined(0.5 * (high + low), 0.5 * (high - low) / q);
  }
  const double q = std::sqrt(-m_square);
  const std::complex<double> lambda(m_mean, q);
  const std::complex<double> g = (std::exp(lambda * t) - 1.0) / lambda;
  return combined(g.real(), g.imag() / q);
}

std::optional<TriangleExit> exitWithin(const LinearFlow& flow, const glm::dvec2& from,
                                       double longest) {
  const std::array<double, 3> start = barycentric(from);
  const std::array<double, 3> end = barycentric(flow.at(from, longest));
  std::optional<TriangleExit> first;
  for (int side = 0; side < 3; ++side) {
    const auto i = std::size_t(side);
    if (end[i] >= 0.0)
      continue;
    // The Illinois method: a secant that halves the weight of the end which stays twice.
    double low = 0.0;
    double high = longest;
    double atLow = std::max(start[i], 0.0);
    double atHigh = end[i];
    double root = 0.0;
    int kept = 0;
    for (int step = 0; step < 60 && atLow > 0.0; ++step) {
      root = (low * atHigh - high * atLow) / (atHigh - atLow);
      const double value = barycentric(flow.at(from, root))[i];
      if (value == 0.0 || high - low <= 1e-15 * longest)
        break;
      if (value > 0.0) {
        low = root;
        atLow = value;
        if (std::exchange(kept, 1) == 1)
          atHigh *= 0.5;
      } else {
        high = root;
        atHigh = value;
        if (std::exchange(kept, -1) == -1)
          atLow *= 0.5;
      }
    }
    if (!first || root < first->time)
      first = TriangleExit{root, {}, side};
  }
  if (first)
    first->at = flow.at(from, first->time);
  return first;
}

}  // namespace sline::render
