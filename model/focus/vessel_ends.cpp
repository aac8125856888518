// SPDX-License-Identifier: Apache-2.0
#include "model/focus/vessel_ends.h"

#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <vector>

#include "model/geometry/topology.h"

namespace sline::model {

namespace {

/// Joins sets of vertices (Tarjan 1975, with path halving).
class Unions {
 public:
  explicit Unions(std::size_t count) : m_parent(count) {
    std::iota(m_parent.begin(), m_parent.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { m_parent[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> m_parent;
};

struct Component {
  double area = 0.0;
  bool comesNear = false;
  std::map<std::uint32_t, double> pieces;  ///< area of each piece, by one of its vertices
};

double areaOf(const Mesh& mesh, const Triangle& t) {
  const auto positions = mesh.positions();
  return 0.5 * double(glm::length(glm::cross(positions[t[1]] - positions[t[0]],
                                             positions[t[2]] - positions[t[0]])));
}

}  // namespace

Cut cutNear(const Mesh& mesh, const std::function<bool(const glm::vec3&)>& near) {
  std::vector<char> gone(mesh.vertexCount());
  for (std::size_t i = 0; i < gone.size(); ++i)
    gone[i] = near(mesh.positions()[i]);
  Unions rest(mesh.vertexCount());
  for (const Triangle& t : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k)
      if (!gone[t[k]] && !gone[t[(k + 1) % 3]])
        rest.join(t[k], t[(k + 1) % 3]);
  const Components whole = connectedComponents(mesh);
  std::vector<Component> parts(whole.count);
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
    const Triangle& t = mesh.triangles()[i];
    const double area = areaOf(mesh, t);
    Component& part = parts[whole.ofTriangle[i]];
    part.area += area;
    for (const std::uint32_t v : t) {
      part.comesNear = part.comesNear || gone[v];
      if (!gone[v])
        part.pieces[rest.find(v)] += area / 3.0;
    }
  }
  constexpr double stub = 0.1;
  Cut cut;
  double area = 0.0;
  double left = 0.0;
  for (const Component& part : parts) {
    std::size_t pieces = 0;
    area += part.area;
    for (const auto& [vertex, size] : part.pieces) {
      pieces += size >= stub * part.area;
      left += size;
    }
    cut.ends = cut.ends && (!part.comesNear || pieces < 2);
  }
  cut.share = area > 0.0 ? 1.0 - left / area : 0.0;
  return cut;
}

}  // namespace sline::model
