// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/simplification.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/spatial_order.h"
#include "model/meshing/edge_collapse.h"

namespace sline::model {

namespace {
constexpr int attempts = 8;
constexpr int mostCells = 6;

/// Calls visit(point) for the centres of the equal parts into which a grid divides the triangle.
template <class Visit>
void forSamples(const Mesh& mesh, std::size_t triangle, float spacing, const Visit& visit) {
  const auto& [i, j, k] = mesh.triangles()[triangle];
  const glm::vec3 a = mesh.positions()[i];
  const glm::vec3 u = mesh.positions()[j] - a;
  const glm::vec3 v = mesh.positions()[k] - a;
  const float longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
  // A mesh of one point has no spacing.
  const int cells =
      spacing > 0.0f ? int(std::clamp(std::ceil(longest / spacing), 1.0f, float(mostCells))) : 1;
  const float step = 1.0f / float(cells);
  for (int p = 0; p < cells; ++p)
    for (int q = 0; p + q < cells; ++q) {
      visit(a + (float(p) + 1.0f / 3.0f) * step * u + (float(q) + 1.0f / 3.0f) * step * v);
      if (p + q + 1 < cells)
        visit(a + (float(p) + 2.0f / 3.0f) * step * u + (float(q) + 2.0f / 3.0f) * step * v);
    }
}

/// Lists the places that lie too far from another surface.
struct Deviations {
  float most = 0.0f;
  std::vector<std::uint32_t> beyond;   ///< triangles with a sample farther than the bound
  std::vector<std::uint32_t> nearest;  ///< for each, the nearest triangle of the other surface
};

/// Finds the deviations. Only the largest distance and those beyond the bound matter, so most
/// searches may stop early.
Deviations deviations(const Mesh& mesh, const Bvh& from, float spacing, float bound) {
  std::vector<Closest> farthest(mesh.triangleCount(), Closest{0.0f, 0});
  std::atomic<float> most = 0.0f;
  // Each vertex is visited once, with the last of its triangles.
  std::vector<std::uint32_t> owner(mesh.vertexCount());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const std::uint32_t v : mesh.triangles()[t])
      owner[v] = t;
  parallelFor(mesh.triangleCount(), 256, [&](std::size_t t) {
    const auto look = [&](const glm::vec3& p) {
      float seen = most.load(std::memory_order_relaxed);
      const float enough = std::max(farthest[t].distance, std::min(seen, bound));
      const Closest closest = from.closest(p, enough);
      if (closest.distance > enough)
        farthest[t] = closest;
      while (closest.distance > seen && !most.compare_exchange_weak(seen, closest.distance)) {
      }
    };
    for (const std::uint32_t v : mesh.triangles()[t])
      if (owner[v] == t)
        look(mesh.positions()[v]);
    forSamples(mesh, t, spacing, look);
  });
  Deviations found{.most = most};
  for (std::uint32_t t = 0; t < farthest.size(); ++t)
    if (farthest[t].distance > bound) {
      found.beyond.push_back(t);
      found.nearest.push_back(farthest[t].triangle);
    }
  return found;
}

/// Halves the tolerance of the triangles' vertices and of those around them.
class Tightening {
 public:
  explicit Tightening(const Mesh& mesh) : m_mesh(mesh), m_core(mesh.vertexCount(), 0) {}
  void mark(std::uint32_t triangle) {
    for (const std::uint32_t v : m_mesh.triangles()[triangle])
      m_core[v] = 1;
  }
  void apply(std::vector<float>& tolerances) const {
    std::vector<char> wide = m_core;
    for (int ring = 0; ring < 2; ++ring) {
      const std::vector<char> before = wide;
      for (const Triangle& t : m_mesh.triangles())
        if (before[t[0]] || before[t[1]] || before[t[2]])
          wide[t[0]] = wide[t[1]] = wide[t[2]] = 1;
    }
    for (std::size_t v = 0; v < wide.size(); ++v)
      tolerances[v] *= wide[v] ? 0.5f : 1.0f;
  }

 private:
  const Mesh& m_mesh;
  std::vector<char> m_core;
};
}  // namespace

float farthestSample(const Mesh& mesh, const Bvh& from, float spacing) {
  return deviations(mesh, from, spacing, std::numeric_limits<float>::infinity()).most;
}

MeshPtr collapsed(const MeshPtr& mesh, float tolerance, const std::function<bool()>& goesOn) {
  if (!(tolerance > 0.0f) || mesh->triangleCount() == 0)
    return mesh;
  const std::vector<float> tolerances(mesh->vertexCount(), tolerance);
  Collapsed fewer = withEdgesCollapsed(*mesh, tolerances, goesOn);
  if (fewer.triangles.empty() || fewer.triangles.size() >= mesh->triangleCount())
    return mesh;
  Result<Mesh> made = Mesh::create(std::move(fewer.positions), std::move(fewer.triangles));
  return made.ok() ? std::make_shared<const Mesh>(std::move(*made)) : mesh;
}

float deviation(const MeshPtr& mesh, const MeshPtr& original) {
  if (mesh == original || mesh->triangleCount() == 0)
    return 0.0f;
  const float spacing = meanEdgeLength(original->positions(), original->triangles());
  const float out = farthestSample(*mesh, Bvh(original, spatialOrder(*original)), spacing);
  return std::max(out, farthestSample(*original, Bvh(mesh, spatialOrder(*mesh)), spacing));
}

Simplified simplified(const MeshPtr& mesh, float bound, const std::function<bool()>& goesOn) {
  Simplified same{mesh, 0.0f};
  if (!(bound > 0.0f) || mesh->triangleCount() == 0)
    return same;
  const float spacing = meanEdgeLength(mesh->positions(), mesh->triangles());
  const Bvh original(mesh, spatialOrder(*mesh));
  std::vector<float> tolerances(mesh->vertexCount(), 0.5f * bound);
  for (int attempt = 0; attempt < attempts && goesOn(); ++attempt) {
    Collapsed fewer = withEdgesCollapsed(*mesh, tolerances, goesOn);
    if (fewer.triangles.empty() || fewer.triangles.size() >= mesh->triangleCount())
      return same;
    Result<Mesh> made = Mesh::create(std::move(fewer.positions), std::move(fewer.triangles));
    if (!made.ok())
      return same;
    const auto result = std::make_shared<const Mesh>(std::move(*made));
    const Deviations out = deviations(*result, original, spacing, bound);
    const Deviations back = deviations(*mesh, Bvh(result, spatialOrder(*result)), spacing, bound);
    const float error = std::max(out.most, back.most);
    if (error <= bound)
      return {result, error};
    Tightening tightening(*mesh);
    for (const std::uint32_t triangle : out.nearest)
      tightening.mark(triangle);
    for (const std::uint32_t triangle : back.beyond)
      tightening.mark(triangle);
    tightening.apply(tolerances);
    if (attempt >= 3)
      for (float& tolerance : tolerances)
        tolerance *= 0.7f;
  }
  return same;
}

}  // namespace sline::model
