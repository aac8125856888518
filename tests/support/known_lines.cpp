// SPDX-License-Identifier: Apache-2.0
#include "tests/support/known_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <unordered_map>

#include "tests/support/sheet_grid.h"

namespace sline::test {

namespace {

double profile(const Wave& wave, double t) {
  return wave.height * std::exp(-0.5 * t * t / (wave.sigma * wave.sigma));
}

/// The curvature of a wave's profile and its derivatives by the arc, convex positive.
struct Bend {
  double k, first, second;
};

double bendAt(const Wave& wave, double t) {
  const double s2 = wave.sigma * wave.sigma;
  const double z = profile(wave, t);
  const double slope = -t / s2 * z;
  return -(t * t / s2 - 1.0) / s2 * z / std::pow(1.0 + slope * slope, 1.5);
}
double arcDerivative(const Wave& wave, double t) {
  const double h = 1e-3 * wave.sigma;
  const double slope = t / (wave.sigma * wave.sigma) * profile(wave, t);
  return (bendAt(wave, t + h) - bendAt(wave, t - h)) / (2.0 * h) / std::sqrt(1.0 + slope * slope);
}
Bend bendOf(const Wave& wave, double t) {
  const double h = 1e-2 * wave.sigma;
  const double slope = t / (wave.sigma * wave.sigma) * profile(wave, t);
  return {bendAt(wave, t), arcDerivative(wave, t),
          (arcDerivative(wave, t + h) - arcDerivative(wave, t - h)) / (2.0 * h) /
              std::sqrt(1.0 + slope * slope)};
}

/// Returns where the profile has lines of the kind.
std::vector<double> placesAcross(const Wave& wave, KnownKind kind) {
  if (kind == KnownKind::demarcating)
    return {-wave.sigma, wave.sigma};
  std::vector<double> places;
  const double step = 0.013 * wave.sigma;
  for (double t = -5.0 * wave.sigma; t < 5.0 * wave.sigma; t += step) {
    double low = t;
    double high = t + step;
    const double start = arcDerivative(wave, low);
    if ((start > 0.0) == (arcDerivative(wave, high) > 0.0))
      continue;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      ((arcDerivative(wave, middle) > 0.0) == (start > 0.0) ? low : high) = middle;
    }
    const bool greatest = start > 0.0;
    const double k = bendAt(wave, low);
    if (kind == KnownKind::ridge ? greatest && k > 0.0 : !greatest && k < 0.0)
      places.push_back(low);
  }
  return places;
}

/// Appends the line at that distance from a wave's middle.
void appendAlong(const KnownSheet& sheet, const Wave& wave, double t, bool certain,
                 std::vector<LineSample>& samples) {
  const double step = 0.1;
  const double radius = wave.radius + t;
  const double length = wave.radius == 0.0 ? 4.0 * sheet.halfSize : 2.0 * std::numbers::pi * radius;
  const int count = int(length / step);
  for (int i = 0; i < count; ++i) {
    const double s = (double(i) + 0.5) * length / double(count);
    const glm::dvec2 along(-wave.across.y, wave.across.x);
    const glm::dvec2 p =
        wave.middle + (wave.radius == 0.0
                           ? t * wave.across + (s - 0.5 * length) * along
                           : radius * glm::dvec2(std::cos(s / radius), std::sin(s / radius)));
    if (std::max(std::abs(p.x), std::abs(p.y)) < sheet.halfSize)
      samples.push_back({.at = {p.x, p.y, sheet.heightAt(p)},
                         .length = length / double(count),
                         .certain = certain});
  }
}

std::vector<LineSample> profileLines(const KnownSheet& sheet, const KnownRequest& request) {
  std::vector<LineSample> samples;
  for (const Wave& wave : sheet.waves)
    for (const double t : placesAcross(wave, request.kind)) {
      const Bend bend = bendOf(wave, t);
      const double f = request.featureSize;
      const bool demarcates = request.kind == KnownKind::demarcating;
      const double strength = demarcates ? std::abs(bend.first) * f * f : std::abs(bend.k) * f;
      const double sharpness =
          demarcates ? 1.0 : std::abs(bend.second) / std::pow(std::abs(bend.k), 3.0);
      if (strength > 0.5 * request.threshold && sharpness > 0.5 * request.sharpness)
        appendAlong(sheet, wave, t, strength > request.threshold && sharpness > request.sharpness,
                    samples);
    }
  return samples;
}

/// Finds whether there is a sample within a distance.
class Near {
 public:
  Near(std::span<const LineSample> samples, double distance) : m_distance(distance) {
    for (const LineSample& sample : samples)
      m_cells[key(cell(sample.at.x), cell(sample.at.y))].push_back(sample.at);
  }

  bool any(const glm::dvec3& p) const {
    for (std::int64_t x = cell(p.x) - 1; x <= cell(p.x) + 1; ++x)
      for (std::int64_t y = cell(p.y) - 1; y <= cell(p.y) + 1; ++y) {
        const auto found = m_cells.find(key(x, y));
        if (found != m_cells.end() &&
            std::any_of(found->second.begin(), found->second.end(),
                        [&](const glm::dvec3& q) { return glm::distance(p, q) < m_distance; }))
          return true;
      }
    return false;
  }

 private:
  std::int64_t cell(double x) const { return std::int64_t(std::floor(x / m_distance)); }
  static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1'000'003 + y; }

  double m_distance;
  std::unordered_map<std::int64_t, std::vector<glm::dvec3>> m_cells;
};

}  // namespace

Across acrossOf(const Wave& wave, const glm::dvec2& p) {
  const glm::dvec2 d = p - wave.middle;
  if (wave.radius == 0.0)
    return {glm::dot(d, wave.across), wave.across};
  const double rho = glm::length(d);
  return {rho - wave.radius, rho > 0.0 ? d / rho : glm::dvec2(0.0)};
}

double KnownSheet::heightAt(const glm::dvec2& p) const {
  double z = 0.0;
  for (const Wave& wave : waves)
    z += profile(wave, acrossOf(wave, p).t);
  return z;
}

glm::dvec2 KnownSheet::slopeAt(const glm::dvec2& p) const {
  glm::dvec2 slope(0.0);
  for (const Wave& wave : waves) {
    const Across at = acrossOf(wave, p);
    slope -= at.t / (wave.sigma * wave.sigma) * profile(wave, at.t) * at.direction;
  }
  return slope;
}

model::MeshPtr KnownSheet::mesh(int cells) const {
  std::mt19937 random(11);
  // Not std::uniform_real_distribution, whose numbers differ between libraries.
  const auto any = [&random] { return double(random()) / 4294967296.0 - 0.5; };
  const double cell = 2.0 * halfSize / double(cells);
  std::vector<glm::vec3> positions;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const auto inside = [cells](int k) { return k > 0 && k < cells ? 0.4 : 0.0; };
      const glm::dvec2 p(-halfSize + cell * (double(i) + inside(i) * any()),
                         -halfSize + cell * (double(j) + inside(j) * any()));
      positions.emplace_back(p.x, p.y, heightAt(p));
    }
  std::vector<model::Triangle> triangles;
  const auto at = [&](int i, int j) { return std::uint32_t(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const std::array corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      const std::size_t first = random() % 2;
      triangles.push_back({corners[first], corners[first + 1], corners[first + 2]});
      triangles.push_back({corners[first], corners[first + 2], corners[(first + 3) % 4]});
    }
  return std::make_shared<const model::Mesh>(
      *model::Mesh::create(std::move(positions), std::move(triangles)));
}

KnownSheet scannedSheet() {
  const glm::dvec2 across(std::cos(0.15), std::sin(0.15));
  return {.waves = {{.middle = {-78, 0}, .across = across, .height = 6, .sigma = 3},
                    {.middle = {-46, 0}, .across = across, .height = -6, .sigma = 3},
                    {.middle = {-14, 0}, .across = across, .height = 4, .sigma = 2.5},
                    {.middle = {57, 52}, .radius = 22, .height = 6, .sigma = 3},
                    {.middle = {57, -48}, .radius = 22, .height = -4, .sigma = 2.5}},
          .halfSize = 100};
}

std::vector<LineSample> knownLines(const KnownSheet& sheet, const KnownRequest& request) {
  return request.kind <= KnownKind::demarcating ? profileLines(sheet, request)
                                                : linesOnGrid(sheet, request);
}

Agreement agreementOf(std::span<const LineSample> known, std::span<const LineSample> drawn,
                      const AgreementRule& rule) {
  const auto counts = [&rule](const LineSample& sample) {
    return std::max(std::abs(sample.at.x), std::abs(sample.at.y)) < rule.halfSize - rule.rim;
  };
  Agreement agreement;
  const Near nearKnown(known, rule.tolerance);
  const Near nearDrawn(drawn, rule.tolerance);
  for (const LineSample& sample : known)
    if (sample.certain && counts(sample)) {
      agreement.knownMm += sample.length;
      agreement.recall += nearDrawn.any(sample.at) ? sample.length : 0.0;
    }
  for (const LineSample& sample : drawn)
    if (counts(sample)) {
      agreement.drawnMm += sample.length;
      agreement.precision += nearKnown.any(sample.at) ? sample.length : 0.0;
    }
  agreement.recall /= std::max(agreement.knownMm, 1e-9);
  agreement.precision /= std::max(agreement.drawnMm, 1e-9);
  return agreement;
}

}  // namespace sline::test
