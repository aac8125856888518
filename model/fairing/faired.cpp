// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/faired.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "model/base/parallel.h"
#include "model/fairing/bounded_relaxation.h"
#include "model/fairing/vertex_rings.h"
#include "model/fairing/windowed_sinc.h"

namespace sline::model {

namespace {

constexpr std::size_t fairingGrain = 3072;
// Waves shorter than this many slices are taken out.
constexpr float shortestWave = 23.0f;
// What a neighbourhood moves by in common is given back: the standard deviation of its weights, in
// slices, and its limits in edges.
constexpr float neighbourhoodReach = 4.0f;
constexpr float leastReach = 2.9f;
constexpr float mostReach = 7.2f;
// Steps of averaging that take the slices' own direction out of the normals.
constexpr int normalSteps = 6;
// Limits of the filter's work where triangles are small beside slices.
constexpr int fewestSteps = 20;
constexpr int mostSteps = 120;

std::vector<glm::vec3> evenNormals(std::span<const glm::vec3> positions,
                                   std::span<const Triangle> triangles, const VertexRings& rings) {
  std::vector<glm::vec3> normals = areaNormals(positions, triangles);
  averageOverRings(normals, rings, normalSteps);
  for (glm::vec3& n : normals) {
    const float length = glm::length(n);
    n = length > 0.0f ? n / length : glm::vec3(0.0f);
  }
  return normals;
}

SincFilter filterFor(float edgesPerWave) {
  const float band =
      1.0f - std::cos(2.0f * std::numbers::pi_v<float> / std::max(edgesPerWave, 4.0f));
  // The narrower the band, the longer the series that tells it from its surroundings.
  const int steps = int(std::lround(10.0f / std::sqrt(band)));
  return {.iterations = std::clamp(steps, fewestSteps, mostSteps),
          .passBand = std::max(band, 0.01f)};
}

double sixfoldVolume(std::span<const glm::vec3> positions, std::span<const Triangle> triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles)
    sum += double(glm::dot(positions[t[0]], glm::cross(positions[t[1]], positions[t[2]])));
  return sum;
}

double twofoldArea(std::span<const glm::vec3> positions, std::span<const Triangle> triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles)
    sum += double(glm::length(
        glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]])));
  return sum;
}

}  // namespace

MeshPtr faired(const MeshPtr& mesh, float sliceDistance) {
  if (!(sliceDistance > 0.0f) || mesh->triangleCount() == 0)
    return mesh;
  const std::span<const Triangle> triangles = mesh->triangles();
  const std::size_t count = mesh->vertexCount();
  const VertexRings rings(count, triangles, HalfEdges(count, triangles));
  const glm::vec3 centre = mesh->bounds().centre();
  std::vector<glm::vec3> before(mesh->positions().begin(), mesh->positions().end());
  for (glm::vec3& p : before)
    p -= centre;
  const float edge = rings.meanEdge(before);
  if (!(edge > 0.0f))
    return mesh;
  const std::vector<glm::vec3> normals = evenNormals(before, triangles, rings);
  std::vector<glm::vec3> after =
      windowedSinc(before, rings, filterFor(shortestWave * sliceDistance / edge));
  std::vector<float> move(count);
  for (std::size_t v = 0; v < count; ++v)
    move[v] = glm::dot(after[v] - before[v], normals[v]);
  const std::vector<float> common =
      gaussian(move, before, rings,
               std::clamp(neighbourhoodReach * sliceDistance / edge, leastReach, mostReach));
  for (std::size_t v = 0; v < count; ++v)
    after[v] = rings.onBorder(v) ? before[v] : before[v] + (move[v] - common[v]) * normals[v];
  const std::vector<float> limits(count, fairingShare * sliceDistance);
  limitMoves(after, before, limits);
  relaxWithin(after, before, limits, rings);
  // Both volumes belong to the same borders, so their difference is that of the surfaces.
  const double lost = (sixfoldVolume(before, triangles) - sixfoldVolume(after, triangles)) / 6.0;
  const double area = 0.5 * twofoldArea(after, triangles);
  const float back = area > 0.0 ? float(lost / area) : 0.0f;
  const Box& box = mesh->bounds();
  parallelFor(count, fairingGrain, [&](std::size_t v) {
    if (!rings.onBorder(v))
      after[v] += back * normals[v];
  });
  limitMoves(after, before, limits);
  for (std::size_t v = 0; v < count; ++v)
    after[v] = glm::clamp(after[v] + centre, box.low, box.high);
  Result<Mesh> made =
      Mesh::create(std::move(after), std::vector<Triangle>(triangles.begin(), triangles.end()));
  return made ? std::make_shared<const Mesh>(std::move(*made)) : mesh;
}

MeshPtr withoutSmallForms(const Mesh& mesh, float deviation) {
  const std::span<const Triangle> triangles = mesh.triangles();
  const VertexRings rings(mesh.vertexCount(), triangles, HalfEdges(mesh.vertexCount(), triangles));
  const glm::vec3 centre = mesh.bounds().centre();
  std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  for (glm::vec3& p : positions)
    p -= centre;
  const float edge = std::max(rings.meanEdge(positions), 1e-20f);
  positions = gaussian(positions, rings, deviation / edge);
  for (glm::vec3& p : positions)
    p += centre;
  std::vector<Triangle> same(triangles.begin(), triangles.end());
  Result<Mesh> made = Mesh::create(std::move(positions), std::move(same));
  if (!made)
    return std::make_shared<const Mesh>(mesh);
  return std::make_shared<const Mesh>(std::move(*made));
}

}  // namespace sline::model
