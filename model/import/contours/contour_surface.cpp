// SPDX-License-Identifier: Apache-2.0
#include "model/import/contours/contour_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "model/fairing/half_edges.h"
#include "model/fairing/vertex_rings.h"
#include "model/fairing/windowed_sinc.h"
#include "model/import/contours/stack_field.h"
#include "model/isosurface/zero_surface.h"

namespace sline::model {

namespace {

constexpr int iterations = 40;
/// Waves shorter than this many spacings of slices are the slices' jitter, not the organ's form.
constexpr double shortestWave = 8.0;
constexpr double farthestMove = 0.75;  ///< as a multiple of the spacing

/// Returns the filter with the pass band 1 − cos(2π·edge/wave), which keeps longer waves.
SincFilter filterFor(float edge, double spacing) {
  const double share = std::clamp(double(edge) / (shortestWave * spacing), 0.02, 0.075);
  return {iterations, float(1.0 - std::cos(2.0 * std::numbers::pi * share))};
}

/// Makes the surface where the values are 0, in (u, v, n) about the middle of the box.
void isosurface(const FieldBox& box, RawMesh& mesh) {
  const glm::dvec3 half = 0.5 * box.step * glm::dvec3(box.size - 1);
  ZeroSurface surface =
      zeroSurface({.size = box.size, .origin = -half, .step = box.step, .values = box.values});
  mesh.positions = std::move(surface.positions);
  mesh.triangles = std::move(surface.triangles);
}

double signedVolume(const RawMesh& mesh) {
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += double(glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c])));
  return volume;
}

void smoothLightly(RawMesh& mesh, const Smoothing& smoothing, double spacing) {
  const HalfEdges edges(mesh.positions.size(), mesh.triangles);
  const VertexRings rings(mesh.positions.size(), mesh.triangles, edges);
  SincFilter filter = filterFor(rings.meanEdge(mesh.positions), spacing);
  if (smoothing.mode == Smoothing::Mode::steps)
    filter.iterations = std::clamp(smoothing.steps, 1, 200);
  const double farthest = farthestMove * spacing;
  const std::vector<glm::vec3> filtered = windowedSinc(mesh.positions, rings, filter);
  for (std::size_t v = 0; v < filtered.size(); ++v) {
    glm::vec3 way = filtered[v] - mesh.positions[v];
    const float length = glm::length(way);
    if (!(length > 0.0f))
      continue;
    if (length > float(farthest))
      way *= float(farthest) / length;
    mesh.positions[v] += way;
    mesh.displacement = std::max(mesh.displacement, std::min(length, float(farthest)));
  }
}

}  // namespace

RawMesh surfaceOf(const ContourStack& stack, double samples, const ReadOptions& options) {
  RawMesh mesh;
  const FieldBox box = fieldOf(stack, samples, options.goesOn);
  if (box.values.empty())
    return mesh;
  isosurface(box, mesh);
  if (mesh.triangles.empty())
    return mesh;
  if (signedVolume(mesh) < 0.0)
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
  if (options.smoothing.mode != Smoothing::Mode::off)
    smoothLightly(mesh, options.smoothing, stack.spacing);
  const glm::dvec3 centre = box.origin + 0.5 * box.step * glm::dvec3(box.size - 1);
  for (glm::vec3& p : mesh.positions)
    p = glm::vec3(stack.axes * (centre + glm::dvec3(p)));
  mesh.smooth = true;
  return mesh;
}

}  // namespace sline::model
