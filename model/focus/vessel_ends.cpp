// SPDX-License-Identifier: Apache-2.0
#include "model/focus/vessel_ends.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <span>
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

/// Finds which of the places are near. A distance changes no faster than the place does, so one
/// question about the middle of a set answers for all of it, unless the border runs through it:
/// then each half is asked about.
class Nearness {
 public:
  Nearness(std::span<const glm::vec3> places, float width, const IsNearer& isNearer)
      : m_places(places), m_width(width), m_isNearer(isNearer), m_near(places.size(), 0) {
    m_order.resize(places.size());
    std::iota(m_order.begin(), m_order.end(), 0u);
    ask(m_order);
  }
  const std::vector<char>& answers() const { return m_near; }

 private:
  void ask(std::span<std::uint32_t> some) {
    constexpr std::size_t few = 3;
    if (some.size() <= few) {
      for (const std::uint32_t i : some)
        m_near[i] = m_isNearer(m_places[i], m_width) ? 1 : 0;
      return;
    }
    Box box;
    for (const std::uint32_t i : some)
      box.add(m_places[i]);
    const glm::vec3 middle = 0.5f * (box.low + box.high);
    const float radius = 1.001f * glm::distance(middle, box.high);
    if (!m_isNearer(middle, m_width + radius))
      return;
    if (m_width > radius && m_isNearer(middle, m_width - radius)) {
      for (const std::uint32_t i : some)
        m_near[i] = 1;
      return;
    }
    const glm::vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto half = std::ptrdiff_t(some.size() / 2);
    std::nth_element(
        some.begin(), some.begin() + half, some.end(),
        [&](std::uint32_t a, std::uint32_t b) { return m_places[a][axis] < m_places[b][axis]; });
    ask(some.first(std::size_t(half)));
    ask(some.subspan(std::size_t(half)));
  }

  std::span<const glm::vec3> m_places;
  float m_width;
  const IsNearer& m_isNearer;
  std::vector<char> m_near;
  std::vector<std::uint32_t> m_order;
};

}  // namespace

Cut cutNear(const Mesh& mesh, float width, const IsNearer& isNearer) {
  const Nearness nearness(mesh.positions(), width, isNearer);
  const std::vector<char>& gone = nearness.answers();
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
