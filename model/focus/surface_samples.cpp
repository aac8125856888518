// SPDX-License-Identifier: Apache-2.0
#include "model/focus/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {

glm::dvec3 twiceArea(const Mesh& mesh, const Triangle& t) {
  const auto positions = mesh.positions();
  const glm::dvec3 a(positions[t[0]]);
  return glm::cross(glm::dvec3(positions[t[1]]) - a, glm::dvec3(positions[t[2]]) - a);
}

/// Returns the i-th point of a sequence that fills the triangle evenly: Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences" (2018), folded at the diagonal. The corners are taken by
/// index and not by their order around the triangle, which a mirror reverses.
glm::vec3 pointIn(const Mesh& mesh, Triangle t, std::size_t i) {
  constexpr double plastic = 1.32471795724474602596;
  std::sort(t.begin(), t.end());
  double u = std::fmod(0.5 + double(i) / plastic, 1.0);
  double v = std::fmod(0.5 + double(i) / (plastic * plastic), 1.0);
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const auto positions = mesh.positions();
  return glm::vec3((1.0 - u - v) * glm::dvec3(positions[t[0]]) + u * glm::dvec3(positions[t[1]]) +
                   v * glm::dvec3(positions[t[2]]));
}

}  // namespace

std::vector<SurfaceSample> surfaceSamples(const Mesh& mesh, std::size_t count) {
  std::vector<SurfaceSample> samples;
  const double step = surfaceArea(mesh) / double(std::max<std::size_t>(count, 1));
  if (count == 0 || !(step > 0.0))
    return samples;
  samples.reserve(count);
  double passed = 0.0;
  for (const Triangle& t : mesh.triangles()) {
    const glm::dvec3 n = twiceArea(mesh, t);
    const double length = glm::length(n);
    passed += 0.5 * length;
    while (samples.size() < count && (double(samples.size()) + 0.5) * step < passed)
      samples.push_back({pointIn(mesh, t, samples.size()), glm::vec3(n / length)});
  }
  return samples;
}

double surfaceArea(const Mesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles())
    area += 0.5 * glm::length(twiceArea(mesh, t));
  return area;
}

}  // namespace sline::model
