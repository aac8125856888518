// SPDX-License-Identifier: Apache-2.0
// Keeps what is known of a vertex of a surface in one place, as views look at few vertices here and
// there: they wait for memory once for each, and not once for each value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "model/geometry/curvature.h"
#include "model/geometry/mesh.h"

namespace sline::model {

/// Fills one line of a processor's cache. See `Curvature` for e1, k and derivative.
struct alignas(64) SurfaceVertex {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};  ///< unit vector pointing outward
  glm::vec3 e1{0.0f};
  glm::vec2 k{0.0f};
  glm::vec4 derivative{0.0f};
};

/// Returns the vertex' shape operator, a symmetric matrix in space (xx, xy, xz, yy, yz, zz; 1/mm).
std::array<float, 6> shapeOperator(const SurfaceVertex& vertex);

/// Reads one value of all vertices of a surface as a vector would; belongs to that surface.
template <class Value, Value SurfaceVertex::*member>
class VertexColumn {
 public:
  VertexColumn() = default;
  explicit VertexColumn(std::span<const SurfaceVertex> vertices) : m_vertices(vertices) {}
  std::size_t size() const { return m_vertices.size(); }
  const Value& operator[](std::size_t vertex) const { return m_vertices[vertex].*member; }

 private:
  std::span<const SurfaceVertex> m_vertices;
};

using NormalColumn = VertexColumn<glm::vec3, &SurfaceVertex::normal>;

struct CurvatureColumns {
  VertexColumn<glm::vec3, &SurfaceVertex::e1> e1;
  VertexColumn<glm::vec2, &SurfaceVertex::k> k;
  VertexColumn<glm::vec4, &SurfaceVertex::derivative> derivative;
};

/// Holds the vertices of a surface. It does not move once it is made, so that columns may refer to
/// it.
class SurfaceVertices {
 public:
  SurfaceVertices() = default;
  SurfaceVertices(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                  const Curvature& curvature);
  /// Takes those of the finer surface's vertices.
  SurfaceVertices(std::span<const SurfaceVertex> finer, std::span<const std::uint32_t> places);
  std::size_t size() const { return m_vertices.size(); }
  const SurfaceVertex& operator[](std::size_t vertex) const { return m_vertices[vertex]; }
  std::span<const SurfaceVertex> all() const { return m_vertices; }

 private:
  std::vector<SurfaceVertex> m_vertices;
};

}  // namespace sline::model
