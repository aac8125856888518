// SPDX-License-Identifier: Apache-2.0
#include "render/lines/linear_flow.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace sline::render {

namespace {

// Where A changes nothing by more than this within t, the series are exact after so many terms.
constexpr double smallStep = 0.5;
constexpr int terms = 16;
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
  const Solution s = solution(t);
  return times(s.power, from) + times(s.integral, m_e);
}

LinearFlow::Solution LinearFlow::solution(double t) const {
  return m_largest * std::abs(t) <= smallStep ? series(t) : closedForm(t);
}

/// Sums exp(At) = Σ (At)ᵏ/k! and its integral t·Σ (At)ᵏ/(k + 1)!.
LinearFlow::Solution LinearFlow::series(double t) const {
  Matrix power{1.0, 0.0, 0.0, 1.0};
  Solution sum{power, {t, 0.0, 0.0, t}};
  for (int k = 1; k < terms; ++k) {
    const double share = t / double(k);
    power = {share * (power[0] * m_a[0] + power[1] * m_a[2]),
             share * (power[0] * m_a[1] + power[1] * m_a[3]),
             share * (power[2] * m_a[0] + power[3] * m_a[2]),
             share * (power[2] * m_a[1] + power[3] * m_a[3])};
    for (std::size_t i = 0; i < 4; ++i) {
      sum.power[i] += power[i];
      sum.integral[i] += t / double(k + 1) * power[i];
    }
  }
  return sum;
}

LinearFlow::Matrix LinearFlow::combined(double x, double y) const {
  return {x + y * (m_a[0] - m_mean), y * m_a[1], y * m_a[2], x + y * (m_a[3] - m_mean)};
}

/// exp(At) = exp(mt)·(cosh(qt)·I + sinh(qt)/q·(A − m·I)). Its integral has the same form: the
/// integrals of both factors are (g(m + q) ± g(m − q)) over 2 and over 2q, g(λ) = (exp(λt) − 1)/λ,
/// which no singular A makes inexact. Where q² < 0 the eigenvalues are conjugate.
LinearFlow::Solution LinearFlow::closedForm(double t) const {
  const double end = std::exp(m_mean * t);
  const double angle = std::sqrt(std::abs(m_square)) * std::abs(t);
  if (angle < smallAngle) {
    const double x = m_square * t * t;
    const double cosh = 1.0 + x / 2.0 * (1.0 + x / 12.0 * (1.0 + x / 30.0));
    const double sinh = t * (1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0)));
    const std::array<double, 6> j = moments(m_mean, t);
    const double q2 = m_square;
    return {combined(end * cosh, end * sinh),
            combined(j[0] + q2 / 2.0 * (j[2] + q2 / 12.0 * j[4]),
                     j[1] + q2 / 6.0 * (j[3] + q2 / 20.0 * j[5]))};
  }
  if (m_square > 0.0) {
    const double q = std::sqrt(m_square);
    const double high = growth(m_mean + q, t);
    const double low = growth(m_mean - q, t);
    return {combined(end * std::cosh(q * t), end * std::sinh(q * t) / q),
            combined(0.5 * (high + low), 0.5 * (high - low) / q)};
  }
  const double q = std::sqrt(-m_square);
  const std::complex<double> lambda(m_mean, q);
  const std::complex<double> g = (std::exp(lambda * t) - 1.0) / lambda;
  return {combined(end * std::cos(q * t), end * std::sin(q * t) / q),
          combined(g.real(), g.imag() / q)};
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
