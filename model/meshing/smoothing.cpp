// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/smoothing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "model/fairing/bounded_relaxation.h"
#include "model/fairing/vertex_rings.h"
#include "model/fairing/windowed_sinc.h"
#include "model/geometry/bounding_sphere.h"
#include "model/geometry/edge_length.h"
#include "model/meshing/loop_subdivision.h"

namespace sline::model {

namespace {

/// By METHOD §5, mean edges longer than this share of the feature size are too coarse to draw.
constexpr float coarsestEdge = 0.02f;
/// A surface that swings about its smoothed copy by at least this, in step heights, counts as
/// stepped.
constexpr float leastSwing = 0.08f;
/// A mesh without a grid never reaches this power, in all and along two of its axes (seen: 90 and
/// 24 among 260 clean anatomical meshes, several hundred on most organs of a label map).
constexpr float certainPower = 100.0f;
constexpr float certainAxisPower = 30.0f;

float totalPower(const VoxelGrid& grid) {
  return grid.power.x + grid.power.y + grid.power.z;
}

bool showsGrid(const SurfaceMeasure& surface) {
  const float power = totalPower(surface.grid);
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
    axes += surface.grid.power[axis] > certainAxisPower;
  return !surface.greyValues && power > certainPower && axes >= 2 &&
         (surface.vertices >= 1000 ||
          (surface.vertices >= 400 && power > 0.5f * float(surface.vertices)));
}

/// Returns the spacing along one axis on which most of the power of all surfaces agrees, within 3
/// %.
float commonSpacing(std::span<const SurfaceMeasure> surfaces, int axis) {
  float best = 0.0f;
  float bestPower = 0.0f;
  for (const SurfaceMeasure& candidate : surfaces) {
    if (!showsGrid(candidate))
      continue;
    const float spacing = candidate.grid.spacing[axis];
    float power = 0.0f;
    for (const SurfaceMeasure& other : surfaces)
      if (showsGrid(other) && std::abs(other.grid.spacing[axis] - spacing) < 0.03f * spacing)
        power += other.grid.power[axis];
    if (power > bestPower) {
      bestPower = power;
      best = spacing;
    }
  }
  return best;
}

/// Moves the centre of the box to the origin, where floats are finest.
std::vector<glm::vec3> centred(std::span<const glm::vec3> positions, const glm::vec3& centre) {
  std::vector<glm::vec3> result(positions.begin(), positions.end());
  for (glm::vec3& p : result)
    p -= centre;
  return result;
}

struct Filtered {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<float> displacement;  ///< along the normal, without its local mean
};

/// Returns low-passed positions. The filter also shrinks thin tubes; that part of the movement,
/// which is the same for a whole neighbourhood, is undone (the idea of J. Vollmer et al., "Improved
/// Laplacian Smoothing of Noisy Surface Meshes", 1999), so that only oscillations are removed.
Filtered filtered(const std::vector<glm::vec3>& positions, std::span<const Triangle> triangles,
                  const VertexRings& rings, const SincFilter& filter) {
  constexpr int neighbourhood = 40;  // averages over about five edges
  Filtered result;
  result.positions = windowedSinc(positions, rings, filter);
  result.normals = areaNormals(result.positions, triangles);
  std::vector<float>& d = result.displacement;
  d.resize(positions.size());
  for (std::size_t v = 0; v < d.size(); ++v)
    d[v] = glm::dot(result.positions[v] - positions[v], result.normals[v]);
  std::vector<float> mean = d;
  averageOverRings(mean, rings, neighbourhood);
  for (std::size_t v = 0; v < d.size(); ++v) {
    if (rings.onBorder(v))
      continue;
    result.positions[v] -= mean[v] * result.normals[v];
    d[v] -= mean[v];
  }
  return result;
}

/// Returns the rms of the swing, in step heights of the grid.
float swing(const Filtered& f, const VoxelGrid& grid) {
  double square = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < f.displacement.size(); ++v) {
    const float step = grid.stepHeight(f.normals[v]);
    if (!(step > 0.0f))
      continue;
    square += double(f.displacement[v] / step) * double(f.displacement[v] / step);
    ++count;
  }
  return float(std::sqrt(square / double(std::max<std::size_t>(1, count))));
}

void smoothPositions(std::vector<glm::vec3>& positions, std::span<const Triangle> triangles,
                     const VoxelGrid& grid, const Smoothing& smoothing, Smoothed& result) {
  const bool asked = smoothing.mode == Smoothing::Mode::steps;
  SincFilter filter;
  if (asked)
    filter.iterations = std::clamp(smoothing.steps, 1, 1000);
  Box box;
  for (const glm::vec3& p : positions)
    box.add(p);
  const VertexRings rings(positions.size(), triangles, HalfEdges(positions.size(), triangles));
  const std::vector<glm::vec3> before = centred(positions, box.centre());
  Filtered after = filtered(before, triangles, rings, filter);
  if (!asked && swing(after, grid) < leastSwing)
    return;
  // The limit is half a step height or, where no grid is known, half an edge.
  const float edge = rings.meanEdge(before);
  std::vector<float> limits(before.size());
  for (std::size_t v = 0; v < limits.size(); ++v)
    limits[v] = 0.49f * (grid.found() ? grid.stepHeight(after.normals[v]) : edge);
  limitMoves(after.positions, before, limits);
  relaxWithin(after.positions, before, limits, rings);
  result.smoothingSteps = filter.iterations;
  result.displacement = farthestMove(before, after.positions);
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (after.positions[v] != before[v])
      positions[v] = after.positions[v] + box.centre();
}

/// Returns the mean angle between the two triangles at an edge, in radians. Above about 45° a
/// surface is a polyhedron on purpose (a box, a plate), not a coarse organ.
float meanBend(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
               const HalfEdges& edges) {
  const auto normal = [&](std::uint32_t t) {
    const Triangle& v = triangles[t];
    return glm::cross(positions[v[1]] - positions[v[0]], positions[v[2]] - positions[v[0]]);
  };
  double sum = 0.0;
  std::size_t count = 0;
  for (std::uint32_t h = 0; h < edges.count(); ++h) {
    if (!edges.hasOpposite(h) || edges.opposite(h) < h)
      continue;
    const glm::vec3 a = normal(h / 3);
    const glm::vec3 b = normal(edges.opposite(h) / 3);
    sum += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    ++count;
  }
  return count == 0 ? 0.0f : float(sum / double(count));
}

int wantedRefinements(float meanEdge, float featureSize) {
  const float share = featureSize > 0.0f ? meanEdge / featureSize : 0.0f;
  return share > 3.0f * coarsestEdge ? 2 : share > coarsestEdge ? 1 : 0;
}

void refine(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles, int allowed,
            Smoothed& result) {
  const float featureSize = smallestBoundingSphere(positions).radius;
  const int steps =
      std::min(allowed, wantedRefinements(meanEdgeLength(positions, triangles), featureSize));
  if (steps == 0)
    return;
  constexpr float polyhedral = 0.7853982f;
  if (meanBend(positions, triangles, HalfEdges(positions.size(), triangles)) > polyhedral)
    return;
  const std::vector<glm::vec3> before = positions;
  const auto rings = [&] {
    return VertexRings(positions.size(), triangles, HalfEdges(positions.size(), triangles));
  };
  positions = interpolatingControl(positions, rings());
  for (int i = 0; i < steps; ++i) {
    Subdivided finer = loopSubdivided(positions, triangles);
    positions = std::move(finer.positions);
    triangles = std::move(finer.triangles);
  }
  positions = limitPositions(positions, rings());
  result.refinementSteps = steps;
  result.displacement += farthestMove(before, positions);
}

}  // namespace

SurfaceMeasure measureSurface(std::span<const glm::vec3> positions,
                              std::span<const Triangle> triangles) {
  SurfaceMeasure measure;
  measure.vertices = positions.size();
  measure.triangles = triangles.size();
  measure.featureSize = smallestBoundingSphere(positions).radius;
  measure.meanEdge = meanEdgeLength(positions, triangles);
  measure.grid = findVoxelGrid(positions, measure.meanEdge);
  if (showsGrid(measure))
    measure.greyValues = isGreyValueSurface(positions, measure.grid);
  return measure;
}

std::vector<VoxelGrid> commonGrids(std::span<const SurfaceMeasure> surfaces) {
  std::vector<VoxelGrid> grids(surfaces.size());
  const auto showing = std::count_if(surfaces.begin(), surfaces.end(), showsGrid);
  if (showing == 0)
    return grids;
  VoxelGrid common;
  for (int axis = 0; axis < 3; ++axis)
    common.spacing[axis] = commonSpacing(surfaces, axis);
  const float mean = (common.spacing.x + common.spacing.y + common.spacing.z) / 3.0f;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SurfaceMeasure& surface = surfaces[i];
    const bool sibling = showing >= 3 && !surface.greyValues && surface.meanEdge > 0.5f * mean &&
                         surface.meanEdge < 2.5f * mean;
    if (sibling)
      grids[i].spacing = common.spacing;
    else if (showsGrid(surface))
      grids[i] = surface.grid;
  }
  return grids;
}

std::vector<int> refinementAllowances(std::span<const SurfaceMeasure> surfaces) {
  constexpr double wholeScene = 800'000.0;
  constexpr double allowedShare = 0.15;
  std::vector<std::size_t> order(surfaces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto share = [&](std::size_t i) {
    return surfaces[i].meanEdge / std::max(surfaces[i].featureSize, 1e-30f);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return share(a) > share(b); });
  double triangles = 0.0;
  for (const SurfaceMeasure& surface : surfaces)
    triangles += double(surface.triangles);
  double left = std::max(wholeScene - triangles, allowedShare * triangles);
  std::vector<int> allowed(surfaces.size(), 0);
  for (const std::size_t i : order)
    for (int steps = wantedRefinements(surfaces[i].meanEdge, surfaces[i].featureSize); steps > 0;
         --steps) {
      const double added = double(surfaces[i].triangles) * (std::pow(4.0, steps) - 1.0);
      if (added > left)
        continue;
      left -= added;
      allowed[i] = steps;
      break;
    }
  return allowed;
}

Smoothed smooth(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles,
                const VoxelGrid& grid, const Smoothing& smoothing, int allowedRefinements) {
  Smoothed result;
  const bool steps = smoothing.mode == Smoothing::Mode::steps && smoothing.steps > 0;
  const bool automatic = smoothing.mode == Smoothing::Mode::automatic;
  if (triangles.empty() || (!steps && !automatic))
    return result;
  if (steps || grid.found())
    smoothPositions(positions, triangles, grid, smoothing, result);
  if (automatic)
    refine(positions, triangles, allowedRefinements, result);
  return result;
}

}  // namespace sline::model
