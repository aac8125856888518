// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/surface/pocket_lining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

namespace sline::model {

namespace {

/// How far the lining is raised above the surface, as a share of the reach.
constexpr float raised = 0.01f;
/// The least cosine between the surface's normal and the way to the guest: a wall's far side, which
/// belongs to another pocket or to the outside, looks away.
constexpr float leastFacing = -0.6f;
/// How often the values are averaged over neighbours, so that the lining's edge is a smooth curve.
constexpr int smoothings = 6;
constexpr double smallestPatch = 0.05;

std::vector<glm::vec3> normalsOf(const TriangleMesh& mesh) {
  std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0.0f));
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3& a = mesh.positions[t[0]];
    const glm::vec3 area = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const std::uint32_t corner : t)
      normals[corner] += area;
  }
  for (glm::vec3& normal : normals)
    if (const float length = glm::length(normal); length > 0.0f)
      normal /= length;
  return normals;
}

/// Returns how far inside the lining a place is, in lengths: negative outside.
float depthOf(const glm::vec3& place, const glm::vec3& normal, std::span<const glm::vec3> guest,
              float reach) {
  float nearest = std::numeric_limits<float>::infinity();
  glm::vec3 way(0.0f);
  for (const glm::vec3& each : guest)
    if (const float distance = glm::length(each - place); distance < nearest) {
      nearest = distance;
      way = each - place;
    }
  if (!(nearest < 2.0f * reach))
    return -reach;
  const float facing = nearest > 0.0f ? glm::dot(normal, way) / nearest : 1.0f;
  return std::min(reach - nearest, reach * (facing - leastFacing));
}

/// Gives each vertex the mean of its own value and those of its neighbours.
void smooth(const TriangleMesh& mesh, std::vector<float>& values) {
  std::vector<float> sums = values;
  std::vector<float> counts(values.size(), 1.0f);
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      sums[t[i]] += values[t[(i + 1) % 3]] + values[t[(i + 2) % 3]];
      counts[t[i]] += 2.0f;
    }
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = sums[i] / counts[i];
}

/// Cuts a surface where a value at its vertices passes through zero, and keeps what is positive.
class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, const std::vector<float>& values)
      : m_mesh(mesh), m_values(values) {}

  TriangleMesh kept() {
    for (const Triangle& t : m_mesh.triangles)
      add(t);
    return std::move(m_kept);
  }

 private:
  bool inside(std::uint32_t vertex) const { return m_values[vertex] > 0.0f; }

  void add(const Triangle& t) {
    std::vector<std::uint32_t> outline;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % 3];
      if (inside(from))
        outline.push_back(vertex(from, from));
      if (inside(from) != inside(to))
        outline.push_back(vertex(from, to));
    }
    for (std::size_t i = 2; i < outline.size(); ++i)
      if (outline[i - 1] != outline[i] && outline[0] != outline[i] && outline[0] != outline[i - 1])
        m_kept.triangles.push_back({outline[0], outline[i - 1], outline[i]});
  }

  /// Returns the new vertex where the value is zero between two vertices, or that for one.
  std::uint32_t vertex(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [entry, isNew] =
        m_new.try_emplace({low, high}, std::uint32_t(m_kept.positions.size()));
    if (isNew) {
      const float span = m_values[low] - m_values[high];
      const float at = low == high || span == 0.0f ? 0.0f : m_values[low] / span;
      m_kept.positions.push_back(
          glm::mix(m_mesh.positions[low], m_mesh.positions[high], std::clamp(at, 0.0f, 1.0f)));
    }
    return entry->second;
  }

  const TriangleMesh& m_mesh;
  const std::vector<float>& m_values;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_new;
  TriangleMesh m_kept;
};

/// Leaves out connected patches that are small beside the whole.
void dropSmallPatches(TriangleMesh& mesh) {
  std::vector<std::uint32_t> leader(mesh.positions.size());
  std::iota(leader.begin(), leader.end(), 0u);
  const auto rootOf = [&leader](std::uint32_t v) {
    while (leader[v] != v)
      v = leader[v] = leader[leader[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : {t[1], t[2]})
      leader[rootOf(corner)] = rootOf(t[0]);
  std::map<std::uint32_t, double> areas;
  double whole = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3& a = mesh.positions[t[0]];
    const double area =
        double(glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)));
    areas[rootOf(t[0])] += area;
    whole += area;
  }
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return areas[rootOf(t[0])] < smallestPatch * whole; });
}

/// Forgets vertices that no triangle uses.
TriangleMesh compacted(const TriangleMesh& mesh) {
  TriangleMesh compact;
  std::map<std::uint32_t, std::uint32_t> fresh;
  for (const Triangle& t : mesh.triangles) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [entry, isNew] = fresh.try_emplace(t[i], std::uint32_t(compact.positions.size()));
      if (isNew)
        compact.positions.push_back(mesh.positions[t[i]]);
      own[i] = entry->second;
    }
    compact.triangles.push_back(own);
  }
  return compact;
}

}  // namespace

TriangleMesh pocketLining(const TriangleMesh& surface, std::span<const glm::vec3> guest,
                          float reach) {
  if (guest.empty())
    return {};
  Box box;
  for (const glm::vec3& place : guest)
    box.add(place);
  const std::vector<glm::vec3> normals = normalsOf(surface);
  TriangleMesh lifted = surface;
  std::vector<float> values(surface.positions.size(), -reach);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::vec3& place = surface.positions[i];
    if (glm::length(glm::max(glm::max(box.low - place, place - box.high), 0.0f)) < 2.0f * reach)
      values[i] = depthOf(place, normals[i], guest, reach);
    lifted.positions[i] += raised * reach * normals[i];
  }
  for (int i = 0; i < smoothings; ++i)
    smooth(surface, values);
  TriangleMesh lining = Cutter(lifted, values).kept();
  dropSmallPatches(lining);
  return compacted(lining);
}

}  // namespace sline::model
