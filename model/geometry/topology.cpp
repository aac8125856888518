// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/topology.h"

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <numeric>

#include "model/base/parallel.h"

namespace sline::model {

VertexFaces::VertexFaces(const Mesh& mesh)
    : m_first(mesh.vertexCount() + 1, 0), m_faces(3 * mesh.triangleCount()) {
  const auto triangles = mesh.triangles();
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      ++m_first[v];
  // Exclusive sums are shifted by the fill below to become the start of each row.
  std::exclusive_scan(m_first.begin(), m_first.end(), m_first.begin(), 0u);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (const std::uint32_t v : triangles[f])
      m_faces[m_first[v]++] = std::uint32_t(f);
  for (std::size_t v = mesh.vertexCount(); v > 0; --v)
    m_first[v] = m_first[v - 1];
  m_first[0] = 0;
}

namespace {
/// Visits each edge once, at its lower vertex.
class EdgeVisitor {
 public:
  EdgeVisitor(const Mesh& mesh, const VertexFaces& faces) : m_mesh(mesh), m_faces(faces) {}

  /// Calls visit(other, uses) for the edges from the vertex to those of higher numbers.
  template <class Visit>
  void forEdgesFrom(std::uint32_t vertex, const Visit& visit) {
    m_ends.clear();
    for (const std::uint32_t f : m_faces[vertex])
      for (const std::uint32_t other : m_mesh.triangles()[f])
        if (other > vertex)
          m_ends.push_back(other);
    // In order, so that a vertex of very many triangles costs no more for each of them.
    std::sort(m_ends.begin(), m_ends.end());
    for (auto run = m_ends.begin(); run != m_ends.end();) {
      const auto after = std::find_if(run, m_ends.end(), [run](auto end) { return end != *run; });
      visit(*run, std::size_t(after - run));
      run = after;
    }
  }

 private:
  const Mesh& m_mesh;
  const VertexFaces& m_faces;
  std::vector<std::uint32_t> m_ends;
};
}  // namespace

EdgeCount countEdges(const Mesh& mesh, const VertexFaces& vertexFaces) {
  std::atomic<std::size_t> open = 0;
  std::atomic<std::size_t> nonManifold = 0;
  parallelChunks(mesh.vertexCount(), 8192, [&](std::size_t begin, std::size_t end) {
    EdgeVisitor edges(mesh, vertexFaces);
    std::size_t openHere = 0;
    std::size_t nonManifoldHere = 0;
    for (std::size_t v = begin; v < end; ++v)
      edges.forEdgesFrom(std::uint32_t(v), [&](std::uint32_t, std::size_t uses) {
        openHere += uses == 1;
        nonManifoldHere += uses > 2;
      });
    open += openHere;
    nonManifold += nonManifoldHere;
  });
  return {.open = open, .nonManifold = nonManifold};
}

double rimLength(const Mesh& mesh, const VertexFaces& vertexFaces) {
  double length = 0.0;
  EdgeVisitor edges(mesh, vertexFaces);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
    edges.forEdgesFrom(v, [&](std::uint32_t other, std::size_t uses) {
      if (uses % 2 != 0)
        length += double(glm::distance(mesh.positions()[v], mesh.positions()[other]));
    });
  return length;
}

Components connectedComponents(const Mesh& mesh) {
  // This is union-find over vertices with path halving.
  std::vector<std::uint32_t> parent(mesh.vertexCount());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&parent](std::uint32_t v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles())
    for (const std::uint32_t v : {t[1], t[2]}) {
      const std::uint32_t first = root(t[0]);
      const std::uint32_t other = root(v);
      parent[std::max(first, other)] = std::min(first, other);
    }
  constexpr std::uint32_t unnumbered = ~0u;
  std::vector<std::uint32_t> number(mesh.vertexCount(), unnumbered);
  Components components;
  components.ofTriangle.reserve(mesh.triangleCount());
  for (const Triangle& t : mesh.triangles()) {
    std::uint32_t& n = number[root(t[0])];
    if (n == unnumbered)
      n = std::uint32_t(components.count++);
    components.ofTriangle.push_back(n);
  }
  return components;
}

}  // namespace sline::model
