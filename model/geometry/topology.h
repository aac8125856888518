// SPDX-License-Identifier: Apache-2.0
// Finds which parts of a mesh touch: faces around a vertex, borders, connected components.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Lists for each vertex the triangles that use it, ascending (compressed sparse rows).
class VertexFaces {
 public:
  explicit VertexFaces(const Mesh& mesh);
  std::span<const std::uint32_t> operator[](std::size_t vertex) const {
    return {m_faces.data() + m_first[vertex], m_faces.data() + m_first[vertex + 1]};
  }

 private:
  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_faces;
};

/// Counts how the edges of a mesh are shared. Vertices are compared by index.
struct EdgeCount {
  std::size_t open = 0;         ///< used by one triangle
  std::size_t nonManifold = 0;  ///< used by three or more
  bool closed() const { return open == 0 && nonManifold == 0; }
};
EdgeCount countEdges(const Mesh& mesh, const VertexFaces& vertexFaces);
/// Returns the total length in mm of the edges that an odd number of triangles share: the rims of
/// holes.
double rimLength(const Mesh& mesh, const VertexFaces& vertexFaces);

/// Holds the connected components over shared vertices.
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> ofTriangle;  ///< component of each triangle, numbered from 0
};
Components connectedComponents(const Mesh& mesh);

}  // namespace sline::model
