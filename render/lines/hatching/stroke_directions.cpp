// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/stroke_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
// Hatching serves hollows (S eq. 6): beside a hollow, a bulge counts this much.
constexpr float bulgeShare = 0.3f;
// The standard deviation of the averaging, as a share of F_c, and the most steps for it.
constexpr float averagedOver = 0.2f;
constexpr float mostSteps = 60.0f;

/// A symmetric matrix: xx, xy, xz, yy, yz, zz.
using Tensor = std::array<float, 6>;

void add(Tensor& sum, const Tensor& other, float factor = 1.0f) {
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += factor * other[i];
}

void addAxis(Tensor& sum, const glm::vec3& axis, float curvature) {
  const float strength = curvature < 0.0f ? -curvature : bulgeShare * curvature;
  add(sum,
      {axis.x * axis.x, axis.x * axis.y, axis.x * axis.z, axis.y * axis.y, axis.y * axis.z,
       axis.z * axis.z},
      strength);
}

glm::vec3 times(const Tensor& t, const glm::vec3& v) {
  return {t[0] * v.x + t[1] * v.y + t[2] * v.z, t[1] * v.x + t[3] * v.y + t[4] * v.z,
          t[2] * v.x + t[4] * v.y + t[5] * v.z};
}

/// Returns the axis of the tensor's larger value in the plane across the normal.
glm::vec3 strongest(const Tensor& tensor, const glm::vec3& normal, const glm::vec3& tangent) {
  const glm::vec3 other = glm::cross(normal, tangent);
  const float xx = glm::dot(tangent, times(tensor, tangent));
  const float xy = glm::dot(tangent, times(tensor, other));
  const float yy = glm::dot(other, times(tensor, other));
  const float turn = 0.5f * std::atan2(2.0f * xy, xx - yy);
  return std::cos(turn) * tangent + std::sin(turn) * other;
}

/// Returns an arbitrary unit tangent.
glm::vec3 anyTangent(const glm::vec3& normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 tangent = axis - glm::dot(axis, normal) * normal;
  return tangent / std::max(glm::length(tangent), 1e-20f);
}

/// Moves every tensor halfway towards the mean of its neighbours, weighted by the faces they share.
void average(const model::Mesh& mesh, std::vector<Tensor>& tensors, std::vector<Tensor>& sums,
             std::vector<float>& counts) {
  sums.assign(tensors.size(), Tensor{});
  counts.assign(tensors.size(), 0.0f);
  for (const model::Triangle& t : mesh.triangles()) {
    Tensor all = tensors[t[0]];
    add(all, tensors[t[1]]);
    add(all, tensors[t[2]]);
    for (const std::uint32_t vertex : t) {
      add(sums[vertex], all);
      counts[vertex] += 1.0f;
    }
  }
  // A vertex is itself in each of its faces' sums: the rest are its neighbours, each twice.
  for (std::size_t v = 0; v < tensors.size(); ++v)
    if (counts[v] > 0.0f)
      for (std::size_t i = 0; i < 6; ++i)
        tensors[v][i] = 0.25f * (tensors[v][i] + sums[v][i] / counts[v]);
}

}  // namespace

StrokeDirections::StrokeDirections(const model::Surface& surface)
    : m_packed(surface.normals.size()) {
  const model::CurvatureColumns& curvature = surface.curvature;
  const std::size_t count = m_packed.size();
  std::vector<Tensor> tensors(count);
  for (std::size_t v = 0; v < count; ++v) {
    tensors[v] = {};
    addAxis(tensors[v], curvature.e1[v], curvature.k[v].x);
    addAxis(tensors[v], glm::cross(surface.normals[v], curvature.e1[v]), curvature.k[v].y);
  }
  // One step spreads over a quarter of the edge's square each way.
  const float edges = averagedOver * surface.filigreeSize / std::max(surface.meanEdge, 1e-20f);
  const int steps = int(std::clamp(4.0f * edges * edges, 2.0f, mostSteps));
  std::vector<Tensor> sums;
  std::vector<float> counts;
  for (int i = 0; i < steps; ++i)
    average(*surface.mesh, tensors, sums, counts);
  for (std::size_t v = 0; v < count; ++v)
    m_packed[v] = glm::packSnorm3x10_1x2(
        glm::vec4(strongest(tensors[v], surface.normals[v], anyTangent(surface.normals[v])), 0.0f));
}

}  // namespace sline::render
