// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
constexpr std::size_t trianglesPerLeaf = 4;
constexpr glm::vec3 noDirection(0.0f);

/// Intersects a ray with both sides of a triangle as in Möller and Trumbore, "Fast, Minimum Storage
/// Ray/Triangle Intersection" (1997).
std::optional<Hit> intersect(const Ray& ray, const Mesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const glm::vec3 p0 = mesh.positions()[a];
  const glm::vec3 e1 = mesh.positions()[b] - p0;
  const glm::vec3 e2 = mesh.positions()[c] - p0;
  const glm::vec3 h = glm::cross(ray.direction, e2);
  const float determinant = glm::dot(e1, h);
  if (determinant == 0.0f)
    return std::nullopt;
  const float inverse = 1.0f / determinant;
  const glm::vec3 s = ray.origin - p0;
  const float u = glm::dot(s, h) * inverse;
  if (!(u >= 0.0f && u <= 1.0f))
    return std::nullopt;
  const glm::vec3 q = glm::cross(s, e1);
  const float v = glm::dot(ray.direction, q) * inverse;
  if (!(v >= 0.0f && u + v <= 1.0f))
    return std::nullopt;
  const float t = glm::dot(e2, q) * inverse;
  if (!(t >= ray.nearest && t <= ray.farthest))
    return std::nullopt;
  return Hit{.t = t, .triangle = triangle, .u = u, .v = v};
}

float squared(const glm::vec3& v) {
  return glm::dot(v, v);
}

/// Returns the squared distance from the origin to the segment a … a + e.
float squaredToSegment(const glm::vec3& a, const glm::vec3& e) {
  const float length = squared(e);
  const float t = length > 0.0f ? std::clamp(-glm::dot(a, e) / length, 0.0f, 1.0f) : 0.0f;
  return squared(a + t * e);
}

/// Returns the squared distance from the origin to the triangle: to its plane where the foot of the
/// perpendicular lies inside, else to an edge.
float squaredToTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 n = glm::cross(b - a, c - a);
  const float area = squared(n);
  const bool inside = area > 0.0f && glm::dot(glm::cross(b - a, -a), n) >= 0.0f &&
                      glm::dot(glm::cross(c - b, -b), n) >= 0.0f &&
                      glm::dot(glm::cross(a - c, -c), n) >= 0.0f;
  if (inside) {
    const float height = glm::dot(a, n);
    return height * height / area;
  }
  return std::min(
      {squaredToSegment(a, b - a), squaredToSegment(b, c - b), squaredToSegment(c, a - c)});
}

/// Chooses among numbers that are all numbers.
struct Numbers {
  static float smaller(float a, float b) { return a < b ? a : b; }
  static float larger(float a, float b) { return a > b ? a : b; }
};

/// As fmin and fmax these return the other number where one is not a number; those are calls into a
/// library, which took a tenth of a ray's time.
struct PerhapsNoNumbers {
  static float smaller(float a, float b) { return a < b || b != b ? a : b; }
  static float larger(float a, float b) { return a > b || b != b ? a : b; }
};

/// A node still to be visited, and where the ray enters it.
struct Pending {
  std::uint32_t node = 0;
  float entry = 0.0f;
};

std::size_t leafStart(std::size_t leaf, std::size_t leaves, std::size_t triangles) {
  return leaf * triangles / leaves;
}
}  // namespace

Bvh::Bvh(MeshPtr mesh, std::vector<std::uint32_t> order)
    : m_mesh(std::move(mesh)), m_order(std::move(order)) {
  if (m_order.empty())
    return;
  m_leafCount =
      std::uint32_t(std::bit_ceil((m_order.size() + trianglesPerLeaf - 1) / trianglesPerLeaf));
  m_nodes.resize(2 * std::size_t(m_leafCount) - 1);
  parallelFor(m_leafCount, 2048, [&](std::size_t leaf) {
    Box box;
    const std::size_t end = leafStart(leaf + 1, m_leafCount, m_order.size());
    for (std::size_t i = leafStart(leaf, m_leafCount, m_order.size()); i < end; ++i)
      for (const std::uint32_t v : m_mesh->triangles()[m_order[i]])
        box.add(m_mesh->positions()[v]);
    m_nodes[m_leafCount - 1 + leaf] = {box.low, box.high};
  });
  for (std::size_t i = m_leafCount - 1; i-- > 0;)
    m_nodes[i] = {glm::min(m_nodes[2 * i + 1].low, m_nodes[2 * i + 2].low),
                  glm::max(m_nodes[2 * i + 1].high, m_nodes[2 * i + 2].high)};
}

/// Calls visit(triangle, ray) front to back; visit shortens the ray to skip what lies behind and
/// returns true to stop.
template <class Visit>
void Bvh::traverse(const Ray& ray, const Visit& visit) const {
  if (m_nodes.empty() || ray.direction == noDirection)
    return;
  // Only 0·∞, on a slab's own plane, is not a number.
  const glm::vec3 inverse = 1.0f / ray.direction;
  if (std::isfinite(inverse.x) && std::isfinite(inverse.y) && std::isfinite(inverse.z))
    traverseBy<Numbers>(ray, visit);
  else
    traverseBy<PerhapsNoNumbers>(ray, visit);
}

template <class Choice, class Visit>
void Bvh::traverseBy(const Ray& ray, const Visit& visit) const {
  Ray r = ray;
  const glm::vec3 inverse = 1.0f / r.direction;
  const auto entry = [&](std::size_t node) {
    const glm::vec3 t0 = (m_nodes[node].low - r.origin) * inverse;
    const glm::vec3 t1 = (m_nodes[node].high - r.origin) * inverse;
    // What is not a number is dropped.
    float near = r.nearest;
    float far = r.farthest;
    for (glm::length_t k = 0; k < 3; ++k) {
      near = Choice::larger(near, Choice::smaller(t0[k], t1[k]));
      far = Choice::smaller(far, Choice::larger(t0[k], t1[k]) * 1.0000004f);
    }
    return near <= far ? near : std::numeric_limits<float>::infinity();
  };
  std::array<Pending, 64> stack{};
  std::size_t depth = 0;
  if (const float at = entry(0); std::isfinite(at))
    stack[depth++] = {0, at};
  while (depth > 0) {
    const auto [node, at] = stack[--depth];
    if (at > r.farthest)
      continue;
    if (node >= m_leafCount - 1) {
      const std::size_t leaf = node - (m_leafCount - 1);
      const std::size_t end = leafStart(leaf + 1, m_leafCount, m_order.size());
      for (std::size_t i = leafStart(leaf, m_leafCount, m_order.size()); i < end; ++i)
        if (visit(m_order[i], r))
          return;
      continue;
    }
    Pending nearer{2 * node + 1, entry(2 * std::size_t(node) + 1)};
    Pending farther{2 * node + 2, entry(2 * std::size_t(node) + 2)};
    if (farther.entry < nearer.entry)
      std::swap(nearer, farther);
    if (std::isfinite(farther.entry))
      stack[depth++] = farther;
    if (std::isfinite(nearer.entry))
      stack[depth++] = nearer;
  }
}

std::optional<Hit> Bvh::nearest(const Ray& ray) const {
  std::optional<Hit> best;
  traverse(ray, [&](std::uint32_t triangle, Ray& r) {
    if (const auto hit = intersect(r, *m_mesh, triangle)) {
      best = hit;
      r.farthest = hit->t;
    }
    return false;
  });
  return best;
}

Closest Bvh::closest(const glm::vec3& point, float enough, float farthest) const {
  Closest best;
  if (m_nodes.empty())
    return best;
  float bestSquared = farthest * farthest;
  const auto gap = [&](std::size_t node) {
    return squared(glm::max(glm::max(m_nodes[node].low - point, point - m_nodes[node].high), 0.0f));
  };
  std::array<std::pair<std::uint32_t, float>, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = {0, gap(0)};
  while (depth > 0 && bestSquared > enough * enough) {
    const auto [node, far] = stack[--depth];
    if (!(far < bestSquared))
      continue;
    if (node < m_leafCount - 1) {
      const std::uint32_t left = 2 * node + 1;
      const std::pair<std::uint32_t, float> children[] = {std::pair(left, gap(left)),
                                                          std::pair(left + 1, gap(left + 1))};
      const bool leftFirst = children[0].second <= children[1].second;
      stack[depth++] = children[leftFirst ? 1 : 0];
      stack[depth++] = children[leftFirst ? 0 : 1];
      continue;
    }
    const std::size_t leaf = node - (m_leafCount - 1);
    const std::size_t end = leafStart(leaf + 1, m_leafCount, m_order.size());
    for (std::size_t i = leafStart(leaf, m_leafCount, m_order.size()); i < end; ++i) {
      const auto& [a, b, c] = m_mesh->triangles()[m_order[i]];
      const auto positions = m_mesh->positions();
      const float distance =
          squaredToTriangle(positions[a] - point, positions[b] - point, positions[c] - point);
      if (distance < bestSquared) {
        bestSquared = distance;
        best = {std::sqrt(distance), m_order[i]};
      }
    }
  }
  return best;
}

bool Bvh::isWithin(const glm::vec3& point, float distance) const {
  const float most = distance * distance;
  const auto gap = [&](std::size_t node) {
    return squared(glm::max(glm::max(m_nodes[node].low - point, point - m_nodes[node].high), 0.0f));
  };
  if (m_nodes.empty() || !(gap(0) < most))
    return false;
  // A box of which even the farthest corner is near has something near in it. The margin is for
  // rounding.
  const auto isNearAsAWhole = [&](std::size_t node) {
    return squared(glm::max(point - m_nodes[node].low, m_nodes[node].high - point)) < 0.999f * most;
  };
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t node = stack[--depth];
    if (isNearAsAWhole(node))
      return true;
    if (node < m_leafCount - 1) {
      const std::uint32_t left = 2 * node + 1;
      const std::array gaps{gap(left), gap(left + 1)};
      const std::uint32_t nearer = gaps[0] <= gaps[1] ? 0 : 1;
      for (const std::uint32_t child : {1 - nearer, nearer})
        if (gaps[child] < most)
          stack[depth++] = left + child;
      continue;
    }
    const std::size_t leaf = node - (m_leafCount - 1);
    const std::size_t end = leafStart(leaf + 1, m_leafCount, m_order.size());
    for (std::size_t i = leafStart(leaf, m_leafCount, m_order.size()); i < end; ++i) {
      const auto& [a, b, c] = m_mesh->triangles()[m_order[i]];
      const auto positions = m_mesh->positions();
      const float apart =
          squaredToTriangle(positions[a] - point, positions[b] - point, positions[c] - point);
      if (apart < most && std::sqrt(apart) < distance)
        return true;
    }
  }
  return false;
}

bool Bvh::blocked(const Ray& ray) const {
  bool found = false;
  traverse(ray, [&](std::uint32_t triangle, Ray& r) {
    found = intersect(r, *m_mesh, triangle).has_value();
    return found;
  });
  return found;
}

}  // namespace sline::model
