// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/cluster_order.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "model/base/parallel.h"
#include "model/geometry/clusters.h"
#include "model/geometry/spatial_order.h"

namespace sline::model {

namespace {
// Stretches of the spatial order that are halved down to clusters.
constexpr std::size_t stretch = std::size_t(64) * Clusters::maximumTriangles;
// A difference of normals weighs as much as a distance of that share of half the mesh's length. Of
// a smooth liver of a million triangles, 22 % face the eye neither wholly nor not at all; 31 %
// where place alone counts, 37 % along the spatial order. Larger weights scatter a cluster's
// triangles, which then have more vertices.
constexpr float normalWeight = 0.25f;

/// Where a triangle is and how it faces: its centroid in half lengths of the mesh, its normal times
/// the weight.
using Place = std::array<float, 6>;

/// Halves one stretch.
class Halving {
 public:
  explicit Halving(const Mesh& mesh) : m_mesh(mesh) {
    const glm::vec3 size = mesh.bounds().size();
    const float longest = std::max({size.x, size.y, size.z});
    m_scale = longest > 0.0f ? 2.0f / longest : 0.0f;
  }

  void order(std::span<std::uint32_t> triangles) {
    m_places.resize(triangles.size());
    m_items.resize(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      m_places[i] = placeOf(triangles[i]);
      m_items[i].place = std::uint32_t(i);
    }
    halve(m_items);
    m_before.assign(triangles.begin(), triangles.end());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      triangles[i] = m_before[m_items[i].place];
  }

 private:
  struct Item {
    float along;
    std::uint32_t place;
  };

  Place placeOf(std::uint32_t triangle) const {
    const auto& [a, b, c] = m_mesh.triangles()[triangle];
    const auto p = m_mesh.positions();
    const glm::vec3 centroid = m_scale / 3.0f * (p[a] + p[b] + p[c]);
    const glm::vec3 area = glm::cross(p[b] - p[a], p[c] - p[a]);
    const float length = glm::length(area);
    const glm::vec3 n = length > 0.0f ? normalWeight / length * area : glm::vec3(0.0f);
    return {centroid.x, centroid.y, centroid.z, n.x, n.y, n.z};
  }

  /// Returns the axis along which the items' places spread most.
  std::size_t widestAxis(std::span<const Item> items) const {
    Place low;
    low.fill(std::numeric_limits<float>::infinity());
    Place high;
    high.fill(-std::numeric_limits<float>::infinity());
    for (const Item& item : items)
      for (std::size_t k = 0; k < low.size(); ++k) {
        low[k] = std::min(low[k], m_places[item.place][k]);
        high[k] = std::max(high[k], m_places[item.place][k]);
      }
    std::size_t widest = 0;
    for (std::size_t k = 1; k < low.size(); ++k)
      if (high[k] - low[k] > high[widest] - low[widest])
        widest = k;
    return widest;
  }

  void halve(std::span<Item> items) {
    constexpr std::size_t most = Clusters::maximumTriangles;
    if (items.size() <= most)
      return;
    const std::size_t axis = widestAxis(items);
    for (Item& item : items)
      item.along = m_places[item.place][axis];
    // All clusters but the last are full, so that one is found by a triangle's slot.
    const std::size_t first = (items.size() + most - 1) / most / 2 * most;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(first), items.end(),
                     [](const Item& a, const Item& b) { return a.along < b.along; });
    halve(items.first(first));
    halve(items.subspan(first));
  }

  const Mesh& m_mesh;
  float m_scale;
  std::vector<Place> m_places;
  std::vector<Item> m_items;
  std::vector<std::uint32_t> m_before;
};
}  // namespace

std::vector<std::uint32_t> clusterOrder(const Mesh& mesh) {
  std::vector<std::uint32_t> order = spatialOrder(mesh);
  const std::size_t stretches = (order.size() + stretch - 1) / stretch;
  parallelChunks(stretches, 1, [&](std::size_t begin, std::size_t end) {
    Halving halving(mesh);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t first = i * stretch;
      halving.order(std::span(order).subspan(first, std::min(stretch, order.size() - first)));
    }
  });
  return order;
}

}  // namespace sline::model
