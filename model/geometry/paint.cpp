// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/paint.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/mesh_trees.h"

namespace sline::model {

namespace {

constexpr float nearSize = 0.01f;  // times the half of the box's diagonal
constexpr std::size_t grain = 256;

/// Returns how far what is the same place may lie on the two meshes, in millimetres.
float toleranceBetween(const Mesh& a, const Mesh& b) {
  const float size =
      0.5f * std::max(glm::length(a.bounds().size()), glm::length(b.bounds().size()));
  return std::max({nearSize * size, meanEdgeLength(a.positions(), a.triangles()),
                   meanEdgeLength(b.positions(), b.triangles())});
}

/// Returns the value at the point of the triangle that lies nearest to `p`.
std::uint8_t valueAt(const Mesh& mesh, const Paint& paint, std::uint32_t triangle,
                     const glm::vec3& p) {
  const Triangle& corners = mesh.triangles()[triangle];
  const glm::vec3 a = mesh.positions()[corners[0]];
  const glm::vec3 u = mesh.positions()[corners[1]] - a;
  const glm::vec3 v = mesh.positions()[corners[2]] - a;
  const glm::vec3 n = glm::cross(u, v);
  const float area = std::max(glm::dot(n, n), 1e-30f);
  float second = glm::clamp(glm::dot(glm::cross(p - a, v), n) / area, 0.0f, 1.0f);
  float third = glm::clamp(glm::dot(glm::cross(u, p - a), n) / area, 0.0f, 1.0f);
  if (const float both = second + third; both > 1.0f) {
    second /= both;
    third /= both;
  }
  const float value = (1.0f - second - third) * float(paint[corners[0]]) +
                      second * float(paint[corners[1]]) + third * float(paint[corners[2]]);
  return std::uint8_t(std::lround(value));
}

/// Returns the share of the paint that has no surface near it.
float lostShare(const Mesh& from, const Paint& paint, const Bvh& to, float tolerance) {
  std::vector<std::uint8_t> gone(paint.size(), 0);
  parallelChunks(paint.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      gone[v] = paint[v] > 0 && !to.isWithin(from.positions()[v], tolerance) ? paint[v] : 0;
  });
  double all = 0.0;
  double lost = 0.0;
  for (std::size_t v = 0; v < paint.size(); ++v) {
    all += paint[v];
    lost += gone[v];
  }
  return all > 0.0 ? float(lost / all) : 0.0f;
}

}  // namespace

CarriedPaint carriedPaint(const MeshPtr& from, const Paint& paint, const MeshPtr& to) {
  if (paint.size() != from->vertexCount())
    return {.paint = nullptr, .lost = 1.0f};
  const bool any = std::any_of(paint.begin(), paint.end(), [](std::uint8_t v) { return v > 0; });
  if (!any)
    return {};
  if (from->triangleCount() == 0 || to->triangleCount() == 0)
    return {.paint = nullptr, .lost = 1.0f};
  const BvhPtr tree = treeOf(from);
  const float tolerance = toleranceBetween(*from, *to);
  Paint carried(to->vertexCount(), 0);
  parallelChunks(carried.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const glm::vec3& p = to->positions()[v];
      const Closest near = tree->closest(p, 0.0f, tolerance);
      if (near.distance <= tolerance)
        carried[v] = valueAt(*from, paint, near.triangle, p);
    }
  });
  const float lost = lostShare(*from, paint, *treeOf(to), tolerance);
  if (std::all_of(carried.begin(), carried.end(), [](std::uint8_t v) { return v == 0; }))
    return {.paint = nullptr, .lost = lost};
  return {.paint = std::make_shared<const Paint>(std::move(carried)), .lost = lost};
}

}  // namespace sline::model
