// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/base/parallel.h"
#include "model/fairing/half_edges.h"

namespace sline::model {

/// Lists the neighbours of each vertex along edges (compressed sparse rows), and which vertices lie
/// on an edge that has not exactly two triangles.
class VertexRings {
 public:
  VertexRings(std::size_t vertexCount, std::span<const Triangle> triangles, const HalfEdges& edges);
  /// The neighbours of vertex v are those from first[v] to first[v + 1].
  VertexRings(std::vector<std::uint32_t> first, std::vector<std::uint32_t> neighbours,
              std::vector<char> border);

  std::size_t vertexCount() const { return m_border.size(); }
  std::span<const std::uint32_t> operator[](std::size_t vertex) const {
    return {m_neighbours.data() + m_first[vertex], m_neighbours.data() + m_first[vertex + 1]};
  }
  bool onBorder(std::size_t vertex) const { return m_border[vertex] != 0; }
  /// Calls body(vertex, ring) for every vertex, in parallel. Vertices whose rings are equally long
  /// follow each other, and `ring` is a span of so many, so that the processor never guesses wrong
  /// when a ring ends: twice as fast as vertex by vertex.
  template <class Body>
  void forEach(const Body& body) const {
    parallelChunks(m_order.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        withRing(m_order[i], body);
    });
  }
  /// Returns the mean length of the edges; 0 without edges.
  float meanEdge(std::span<const glm::vec3> positions) const;

 private:
  static constexpr std::size_t grain = 3072;

  template <class Body>
  void withRing(std::uint32_t vertex, const Body& body) const {
    const std::uint32_t* ring = m_neighbours.data() + m_first[vertex];
    const std::size_t length = m_first[vertex + 1] - m_first[vertex];
    switch (length) {
      case 3:
        return body(vertex, std::span<const std::uint32_t, 3>(ring, length));
      case 4:
        return body(vertex, std::span<const std::uint32_t, 4>(ring, length));
      case 5:
        return body(vertex, std::span<const std::uint32_t, 5>(ring, length));
      case 6:
        return body(vertex, std::span<const std::uint32_t, 6>(ring, length));
      case 7:
        return body(vertex, std::span<const std::uint32_t, 7>(ring, length));
      case 8:
        return body(vertex, std::span<const std::uint32_t, 8>(ring, length));
      default:
        return body(vertex, std::span<const std::uint32_t>(ring, length));
    }
  }
  void findOrder();

  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_neighbours;
  std::vector<char> m_border;
  std::vector<std::uint32_t>
      m_order;  ///< all vertices; by the length of their rings, block by block
};

/// Returns unit vertex normals weighted by area, for measuring; vertices without faces get (0, 0,
/// 0).
std::vector<glm::vec3> areaNormals(std::span<const glm::vec3> positions,
                                   std::span<const Triangle> triangles);

}  // namespace sline::model
