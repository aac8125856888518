// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/simplification.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/edge_collapse.h"
#include "model/geometry/spatial_order.h"

namespace sline::model {

namespace {
constexpr int attempts = 8;
constexpr int mostCells = 8;

/// Calls visit(point) for the corners and a grid on the triangle.
template <class Visit>
void forSamples(const Mesh& mesh, std::size_t triangle, float spacing, const Visit& visit) {
  const auto& [i, j, k] = mesh.triangles()[triangle];
  const glm::vec3 a = mesh.positions()[i];
  const glm::vec3 u = mesh.positions()[j] - a;
  const glm::vec3 v = mesh.positions()[k] - a;
  const float longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
  const int cells = int(std::clamp(std::ceil(longest / spacing), 1.0f, float(mostCells)));
  for (int p = 0; p <= cells; ++p)
    for (int q = 0; p + q <= cells; ++q)
      visit(a + (float(p) / float(cells)) * u + (float(q) / float(cells)) * v);
  visit(a + (u + v) / 3.0f);
}

/// Triangles by how far their farthest sample lies from the other surface.
struct Deviation {
  float distance = 0.0f;
  std::uint32_t nearest = 0;  ///< the triangle of the other surface nearest to that sample
};

std::vector<Deviation> deviations(const Mesh& mesh, const Bvh& from, float spacing) {
  std::vector<Deviation> all(mesh.triangleCount());
  parallelFor(mesh.triangleCount(), 256, [&](std::size_t t) {
    forSamples(mesh, t, spacing, [&](const glm::vec3& p) {
      const Closest closest = from.closest(p);
      if (closest.distance >= all[t].distance)
        all[t] = {closest.distance, closest.triangle};
    });
  });
  return all;
}

float largest(const std::vector<Deviation>& all) {
  float most = 0.0f;
  for (const Deviation& one : all)
    most = std::max(most, one.distance);
  return most;
}

/// Halves the tolerance of the triangle's vertices and of those around them.
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
  return largest(deviations(mesh, from, spacing));
}

Simplified simplified(const MeshPtr& mesh, float bound, const std::function<bool()>& goesOn) {
  const Simplified same{mesh, 0.0f};
  if (!(bound > 0.0f) || mesh->triangleCount() == 0)
    return same;
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
    const std::vector<Deviation> out = deviations(*result, original, bound);
    const std::vector<Deviation> back =
        deviations(*mesh, Bvh(result, spatialOrder(*result)), bound);
    const float error = std::max(largest(out), largest(back));
    if (error <= bound)
      return {result, error};
    Tightening tightening(*mesh);
    for (const Deviation& one : out)
      if (one.distance > bound)
        tightening.mark(one.nearest);
    for (std::uint32_t t = 0; t < back.size(); ++t)
      if (back[t].distance > bound)
        tightening.mark(t);
    tightening.apply(tolerances);
    if (attempt >= 3)
      for (float& tolerance : tolerances)
        tolerance *= 0.7f;
  }
  return same;
}

}  // namespace sline::model
