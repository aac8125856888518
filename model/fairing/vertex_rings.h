// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "model/fairing/half_edges.h"

namespace sline::model {

/// Lists the neighbours of each vertex along edges (compressed sparse rows), and which vertices lie
/// on an edge that has not exactly two triangles.
class VertexRings {
 public:
  VertexRings(std::size_t vertexCount, std::span<const Triangle> triangles, const HalfEdges& edges);
  /// The neighbours of vertex v are those from first[v] to first[v + 1].
  VertexRings(std::vector<std::uint32_t> first, std::vector<std::uint32_t> neighbours,
              std::vector<char> border)
      : m_first(std::move(first)),
        m_neighbours(std::move(neighbours)),
        m_border(std::move(border)) {}

  std::size_t vertexCount() const { return m_border.size(); }
  std::span<const std::uint32_t> operator[](std::size_t vertex) const {
    return {m_neighbours.data() + m_first[vertex], m_neighbours.data() + m_first[vertex + 1]};
  }
  bool onBorder(std::size_t vertex) const { return m_border[vertex] != 0; }
  /// Returns the mean length of the edges; 0 without edges.
  float meanEdge(std::span<const glm::vec3> positions) const;

 private:
  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_neighbours;
  std::vector<char> m_border;
};

/// Returns unit vertex normals weighted by area, for measuring; vertices without faces get (0, 0,
/// 0).
std::vector<glm::vec3> areaNormals(std::span<const glm::vec3> positions,
                                   std::span<const Triangle> triangles);

}  // namespace sline::model
