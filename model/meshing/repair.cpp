// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/repair.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <numeric>

#include "model/fairing/half_edges.h"
#include "model/meshing/orientation.h"

namespace sline::model {

namespace {

bool repeatsIndex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

bool withoutArea(const Triangle& t, const std::vector<glm::vec3>& p) {
  const glm::dvec3 a(p[t[0]]);
  const glm::dvec3 n = glm::cross(glm::dvec3(p[t[1]]) - a, glm::dvec3(p[t[2]]) - a);
  return n.x == 0.0 && n.y == 0.0 && n.z == 0.0;
}

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Marks triangles with the same three vertices as an earlier one. Only triangles that share an
/// edge with two others can be among them, so that clean meshes cost nothing.
std::size_t markDuplicates(const std::vector<Triangle>& triangles, const HalfEdges& edges,
                           std::vector<char>& remove) {
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (remove[t])
      continue;
    bool suspect = false;
    bool island = true;  // two equal triangles alone pair up along all three edges
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = edges.opposite(3 * t + k);
      suspect = suspect || other == HalfEdges::shared;
      island = island && other < HalfEdges::shared && other / 3 == edges.opposite(3 * t) / 3;
    }
    if (suspect || island)
      suspects.push_back(t);
  }
  std::sort(suspects.begin(), suspects.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Triangle x = sorted(triangles[a]);
    const Triangle y = sorted(triangles[b]);
    return x != y ? x < y : a < b;
  });
  std::size_t count = 0;
  for (std::size_t i = 1; i < suspects.size(); ++i)
    if (sorted(triangles[suspects[i]]) == sorted(triangles[suspects[i - 1]])) {
      remove[suspects[i]] = 1;
      ++count;
    }
  return count;
}

void removeMarked(std::vector<Triangle>& triangles, const std::vector<char>& remove) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!remove[t])
      triangles[kept++] = triangles[t];
  triangles.resize(kept);
}

/// Returns for each vertex the first one at exactly the same place.
std::vector<std::uint32_t> firstAtSamePlace(const std::vector<glm::vec3>& positions) {
  const auto key = [&](std::uint32_t v) {
    // Adding 0 makes -0 and 0 the same place.
    const glm::vec3 p = positions[v] + 0.0f;
    return std::array{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                      std::bit_cast<std::uint32_t>(p.z)};
  };
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto x = key(a);
    const auto y = key(b);
    return x != y ? x < y : a < b;
  });
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

/// Merges equal vertices where that leaves fewer open edges; vertices keep their order.
int mergeSeams(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles,
               std::size_t openBefore) {
  const std::vector<std::uint32_t> first = firstAtSamePlace(positions);
  std::vector<Triangle> merged(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      merged[t][k] = first[triangles[t][k]];
  const HalfEdges edges(positions.size(), merged);
  if (edges.openCount() >= openBefore)
    return 0;
  std::vector<std::uint32_t> number(positions.size());
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (first[v] == v) {
      positions[kept] = positions[v];
      number[v] = kept++;
    } else {
      number[v] = number[first[v]];
    }
  }
  const int count = int(positions.size() - kept);
  positions.resize(kept);
  positions.shrink_to_fit();
  for (Triangle& t : merged)
    for (std::uint32_t& v : t)
      v = number[v];
  triangles = std::move(merged);
  return count;
}

/// Marks faces that name a vertex twice, and those without area where fewer than three edges hold
/// them; elsewhere their removal would open the surface.
std::size_t markDegenerate(const std::vector<glm::vec3>& positions,
                           const std::vector<Triangle>& triangles, std::vector<char>& remove) {
  std::vector<std::uint32_t> flat;
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (repeatsIndex(triangles[t])) {
      remove[t] = 1;
      ++count;
    } else if (withoutArea(triangles[t], positions)) {
      flat.push_back(t);
    }
  }
  if (flat.empty())
    return count;
  const HalfEdges edges(positions.size(), triangles);
  for (const std::uint32_t t : flat) {
    const bool held =
        edges.hasOpposite(3 * t) && edges.hasOpposite(3 * t + 1) && edges.hasOpposite(3 * t + 2);
    remove[t] = !held;
    count += !held;
  }
  return count;
}

}  // namespace

RepairReport repair(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles) {
  RepairReport report;
  std::vector<char> remove(triangles.size(), 0);
  report.degenerateFaces = int(markDegenerate(positions, triangles, remove));
  if (report.degenerateFaces > 0)
    removeMarked(triangles, remove);

  HalfEdges edges(positions.size(), triangles);
  if (edges.openCount() > 0) {
    report.mergedVertices = mergeSeams(positions, triangles, edges.openCount());
    if (report.mergedVertices > 0) {
      remove.assign(triangles.size(), 0);
      const int flat = int(markDegenerate(positions, triangles, remove));
      if (flat > 0)
        removeMarked(triangles, remove);
      report.degenerateFaces += flat;
      edges = HalfEdges(positions.size(), triangles);
    }
  }
  remove.assign(triangles.size(), 0);
  report.duplicateFaces = int(markDuplicates(triangles, edges, remove));
  if (report.duplicateFaces > 0) {
    removeMarked(triangles, remove);
    edges = HalfEdges(positions.size(), triangles);
  }
  remove = {};
  const Orientation orientation = orient(positions, triangles, edges);
  report.turnedFaces = int(orientation.turned);
  report.notOrientable = orientation.notOrientable;
  return report;
}

}  // namespace sline::model
