// SPDX-License-Identifier: Apache-2.0
// Holds what the writer and the reader of packed meshes both know after each triangle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace sline::model::packing {

/// A triangle's byte: the edge in the upper half, the third vertex in the lower.
inline constexpr unsigned edgesKept = 15;  ///< 0 … 14, counted back from the newest
inline constexpr unsigned noEdge = 15;     ///< the triangle begins anew
inline constexpr unsigned newVertex = 0;
inline constexpr unsigned verticesKept = 14;  ///< 1 … 14, counted back from the newest
inline constexpr unsigned farVertex = 15;     ///< a number of its own says which

/// An edge as the next triangle has it, and the vertex on its other side.
struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t opposite = 0;
};

/// The newest edges and vertices.
class Recent {
 public:
  const Edge& edge(unsigned back) const { return m_edges[(m_edgeCount - 1 - back) % edgeRoom]; }
  unsigned edges() const { return unsigned(m_edgeCount < edgesKept ? m_edgeCount : edgesKept); }
  std::uint32_t vertex(unsigned back) const {
    return m_vertices[(m_vertexCount - 1 - back) % vertexRoom];
  }
  unsigned vertices() const {
    return unsigned(m_vertexCount < verticesKept ? m_vertexCount : verticesKept);
  }
  void addVertex(std::uint32_t vertex) { m_vertices[m_vertexCount++ % vertexRoom] = vertex; }
  /// Adds the sides of a triangle over which others may follow: all, or those besides the first.
  void addTriangle(const std::array<std::uint32_t, 3>& t, bool begins) {
    if (begins)
      addEdge({t[1], t[0], t[2]});
    addEdge({t[2], t[1], t[0]});
    addEdge({t[0], t[2], t[1]});
  }

 private:
  static constexpr std::size_t edgeRoom = 16;
  static constexpr std::size_t vertexRoom = 16;
  void addEdge(const Edge& edge) { m_edges[m_edgeCount++ % edgeRoom] = edge; }

  std::array<Edge, edgeRoom> m_edges{};
  std::array<std::uint32_t, vertexRoom> m_vertices{};
  std::size_t m_edgeCount = 0;
  std::size_t m_vertexCount = 0;
};

/// Positions as whole numbers, and what the next one is expected to be.
class Expected {
 public:
  /// After an edge: the fourth corner of the parallelogram.
  static glm::ivec3 across(const Edge& edge, const std::vector<glm::ivec3>& at) {
    return at[edge.from] + at[edge.to] - at[edge.opposite];
  }
  /// Where a triangle begins: the vertex before.
  static glm::ivec3 after(const std::vector<glm::ivec3>& at) {
    return at.empty() ? glm::ivec3(0) : at.back();
  }
};

}  // namespace sline::model::packing
