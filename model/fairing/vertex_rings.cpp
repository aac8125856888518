// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/vertex_rings.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

namespace sline::model {

namespace {
// Vertices are put in another order only within blocks of so many, which lie together in memory.
constexpr std::size_t blockSize = 1024;
constexpr std::size_t longestCounted = 31;
}  // namespace

VertexRings::VertexRings(std::size_t vertexCount, std::span<const Triangle> triangles,
                         const HalfEdges& edges)
    : m_first(vertexCount + 2, 0), m_border(vertexCount, 0) {
  const auto from = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  // This visits each edge once, by the smaller of its half-edges. Edges of three triangles are
  // visited three times, which only makes their (fixed) vertices' rings longer.
  const auto forEachEdge = [&](const auto& visit) {
    for (std::uint32_t h = 0; h < edges.count(); ++h) {
      if (edges.hasOpposite(h) && edges.opposite(h) < h)
        continue;
      visit(h, from(h), from(nextInTriangle(h)));
    }
  };
  forEachEdge([&](std::uint32_t h, std::uint32_t a, std::uint32_t b) {
    ++m_first[a + 2];
    ++m_first[b + 2];
    if (!edges.hasOpposite(h))
      m_border[a] = m_border[b] = 1;
  });
  for (std::size_t v = 2; v < m_first.size(); ++v)
    m_first[v] += m_first[v - 1];
  m_neighbours.resize(m_first.back());
  forEachEdge([&](std::uint32_t, std::uint32_t a, std::uint32_t b) {
    m_neighbours[m_first[a + 1]++] = b;
    m_neighbours[m_first[b + 1]++] = a;
  });
  findOrder();
}

VertexRings::VertexRings(std::vector<std::uint32_t> first, std::vector<std::uint32_t> neighbours,
                         std::vector<char> border)
    : m_first(std::move(first)), m_neighbours(std::move(neighbours)), m_border(std::move(border)) {
  findOrder();
}

void VertexRings::findOrder() {
  m_order.resize(vertexCount());
  const auto counted = [this](std::size_t v) {
    return std::min((*this)[v].size(), longestCounted);
  };
  for (std::size_t begin = 0; begin < m_order.size(); begin += blockSize) {
    const std::size_t end = std::min(begin + blockSize, m_order.size());
    std::array<std::size_t, longestCounted + 2> place{begin};
    for (std::size_t v = begin; v < end; ++v)
      ++place[counted(v) + 1];
    for (std::size_t length = 1; length < place.size(); ++length)
      place[length] += place[length - 1];
    for (std::size_t v = begin; v < end; ++v)
      m_order[place[counted(v)]++] = std::uint32_t(v);
  }
}

float VertexRings::meanEdge(std::span<const glm::vec3> positions) const {
  double sum = 0.0;
  for (std::size_t v = 0; v < vertexCount(); ++v)
    for (const std::uint32_t other : (*this)[v])
      sum += glm::distance(positions[v], positions[other]);
  return float(sum / double(std::max<std::size_t>(1, m_neighbours.size())));
}

std::vector<glm::vec3> areaNormals(std::span<const glm::vec3> positions,
                                   std::span<const Triangle> triangles) {
  std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0f));
  for (const Triangle& t : triangles) {
    const glm::vec3& a = positions[t[0]];
    const glm::vec3 n = glm::cross(positions[t[1]] - a, positions[t[2]] - a);
    for (const std::uint32_t v : t)
      normals[v] += n;
  }
  for (glm::vec3& n : normals) {
    const float length = glm::length(n);
    n = length > 0.0f ? n / length : glm::vec3(0.0f);
  }
  return normals;
}

}  // namespace sline::model
