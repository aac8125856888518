// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/hatch_seeds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>

namespace sline::render {

namespace {
// Barycentric: a lattice point on an edge is found from both sides rather than from neither.
constexpr float slack = 1e-4f;
// A sphere around vertices holds them within a share of its radius and of the surface's.
constexpr float roundedOut = 1.001f;
constexpr float roundedPlace = 1e-6f;

/// Scatters the lattice's points; gives the same for a point and its mirror images.
std::uint32_t scattered(const HatchSeed& s) {
  std::uint32_t h = std::uint32_t(std::abs(s.i)) * 0x9e3779b1u;
  h ^= std::uint32_t(std::abs(s.j)) * 0x85ebca77u + (h << 6) + (h >> 2);
  h ^= std::uint32_t(s.axis) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  return h ^ (h >> 15);
}

/// Returns the name of point (i, j) of the lattice of that level on the coarsest lattice that has
/// it.
HatchSeed named(int axis, int level, std::int32_t i, std::int32_t j) {
  const std::uint32_t both = std::uint32_t(i) | std::uint32_t(j);
  const int shared = both == 0 ? 30 : std::countr_zero(both);
  const int up = std::min(shared, level - coarsestHatchLevel);
  return {.axis = axis, .level = level - up, .i = i / (1 << up), .j = j / (1 << up)};
}

class Seeder {
 public:
  Seeder(const model::Surface& surface, int level, const model::Box& box)
      : m_surface(surface),
        m_level(level),
        m_cell(std::ldexp(surface.filigreeSize, -level)),
        m_box(box) {}

  /// Tells whether a lattice's points may lie on what is within the sphere: whether its shadow
  /// along one of the axes holds any.
  bool mayHold(const model::Sphere& bounds) const {
    const glm::vec3 centre = bounds.centre - m_surface.boundingSphere.centre;
    const float radius =
        roundedOut * bounds.radius + roundedPlace * m_surface.boundingSphere.radius;
    return columns((centre - radius) / m_cell, (centre + radius) / m_cell) > 1;
  }

  void seed(std::uint32_t triangle) {
    const model::Triangle& t = m_surface.mesh->triangles()[triangle];
    const auto positions = m_surface.mesh->positions();
    std::array<glm::vec3, 3> p;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = positions[t[c]] - m_surface.boundingSphere.centre;
    const glm::vec3 low = glm::max(glm::min(glm::min(p[0], p[1]), p[2]), m_box.low);
    const glm::vec3 high = glm::min(glm::max(glm::max(p[0], p[1]), p[2]), m_box.high);
    if (glm::any(glm::greaterThan(low, high)) || columns(low / m_cell, high / m_cell) < 2)
      return;
    const glm::vec3 normal = glm::abs(glm::cross(p[1] - p[0], p[2] - p[0]));
    const int axis = normal.x >= normal.y && normal.x >= normal.z ? 0
                     : normal.y >= normal.z                       ? 1
                                                                  : 2;
    scan(triangle, axis, p, {low / m_cell, high / m_cell});
  }

  std::vector<PlacedSeed> take() {
    const auto order = [](const PlacedSeed& s) {
      const HatchSeed& n = s.name;
      return std::tuple(n.level, scattered(n), n.axis, n.i, n.j, s.at.triangle);
    };
    std::sort(m_seeds.begin(), m_seeds.end(),
              [&](const PlacedSeed& a, const PlacedSeed& b) { return order(a) < order(b); });
    return std::move(m_seeds);
  }

 private:
  /// Returns across how many of the axes a plane of the lattice passes between the two, in cells. A
  /// point lies on two of them.
  static int columns(const glm::vec3& low, const glm::vec3& high) {
    const auto passes = glm::lessThanEqual(glm::ceil(low), glm::floor(high));
    return int(passes.x) + int(passes.y) + int(passes.z);
  }

  /// Visits every lattice point within the triangle's projection and the box, given in cells.
  void scan(std::uint32_t triangle, int axis, const std::array<glm::vec3, 3>& p,
            const model::Box& cells) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto flat = [&](const glm::vec3& q) { return glm::vec2(q[u], q[v]); };
    const glm::vec2 low = glm::ceil(flat(cells.low));
    const glm::vec2 high = glm::floor(flat(cells.high));
    const glm::vec2 origin = flat(p[0]) / m_cell;
    const glm::vec2 a = flat(p[1]) / m_cell - origin;
    const glm::vec2 b = flat(p[2]) / m_cell - origin;
    const float area = a.x * b.y - a.y * b.x;
    if (area == 0.0f || glm::any(glm::greaterThan(glm::abs(low), glm::vec2(1e9f))))
      return;
    for (float y = low.y; y <= high.y; y += 1.0f)
      for (float x = low.x; x <= high.x; x += 1.0f) {
        const glm::vec2 d = glm::vec2(x, y) - origin;
        const float b1 = (d.x * b.y - d.y * b.x) / area;
        const float b2 = (a.x * d.y - a.y * d.x) / area;
        const glm::vec3 at(1.0f - b1 - b2, b1, b2);
        if (std::min({at.x, at.y, at.z}) >= -slack)
          add({triangle, glm::max(at, glm::vec3(0.0f))},
              named(axis, m_level, std::int32_t(x), std::int32_t(y)));
      }
  }

  void add(const SurfacePoint& at, const HatchSeed& name) {
    const glm::vec3 position = valueAt(*m_surface.mesh, m_surface.mesh->positions(), at);
    const glm::vec3 local = position - m_surface.boundingSphere.centre;
    if (glm::all(glm::greaterThanEqual(local, m_box.low)) &&
        glm::all(glm::lessThan(local, m_box.high)))
      m_seeds.push_back({.name = name, .at = at, .position = position});
  }

  const model::Surface& m_surface;
  int m_level;
  float m_cell;  ///< mm
  model::Box m_box;
  std::vector<PlacedSeed> m_seeds;
};

}  // namespace

std::vector<PlacedSeed> hatchSeeds(const model::Surface& surface, int level, const model::Box& box,
                                   std::span<const std::uint32_t> clusters) {
  Seeder seeder(surface, level, box);
  for (const std::uint32_t c : clusters) {
    const model::Cluster& cluster = surface.clusters.items[c];
    if (!seeder.mayHold(cluster.bounds))
      continue;
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i)
      seeder.seed(surface.clusters.triangles[cluster.firstTriangle + i]);
  }
  return seeder.take();
}

}  // namespace sline::render
