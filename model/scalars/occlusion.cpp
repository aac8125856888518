// SPDX-License-Identifier: Apache-2.0
#include "model/scalars/occlusion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "model/base/parallel.h"
#include "model/fairing/half_edges.h"
#include "model/fairing/vertex_rings.h"
#include "model/geometry/mesh_trees.h"
#include "model/geometry/spatial_order.h"
#include "model/scalars/ring_diffusion.h"

namespace sline::model {

namespace {

// Rays of a whole surface, about; at each starting point no fewer and no more than these.
constexpr std::size_t raysInAll = 1'500'000;
constexpr std::size_t fewestRays = 64;
constexpr std::size_t mostRays = 128;
// Surfaces of up to so many vertices have rays from each of them.
constexpr std::size_t mostPoints = 24'000;
// Rays start this far above the surface, times F.
constexpr float lift = 1e-4f;
// One edge takes out what noise is left where rays start at every vertex.
constexpr int ownDiffusion = 3;
// Deviation of the filter between starting points, times their distance.
constexpr float filterWidth = 0.7f;

/// Returns the index as a fraction with its bits in reverse order (van der Corput).
float radicalInverse(std::uint32_t bits) {
  bits = (bits << 16) | (bits >> 16);
  bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
  bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
  bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
  bits = ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
  return float(bits) * 0x1p-32f;
}

/// Returns a number that looks like chance, 0 … 1.
float scattered(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return float(x) * 0x1p-32f;
}

/// Casts the rays of one vertex.
class Sky {
 public:
  Sky(const Surface& surface, std::size_t rays)
      : m_surface(surface), m_tree(treeOf(surface.mesh)), m_rays(rays) {}

  /// Returns the hidden share of the sky above the vertex.
  float hiddenAt(std::uint32_t vertex) const {
    const glm::vec3 n = m_surface.normals[vertex];
    if (n == glm::vec3(0.0f))
      return 0.0f;
    // A frame without a case for any direction: T. Duff et al., "Building an Orthonormal Basis,
    // Revisited" (2017).
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    const glm::vec3 t{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    const glm::vec3 u{b, sign + n.y * n.y * a, -n.y};
    const glm::vec3 origin = m_surface.mesh->positions()[vertex] + lift * m_surface.featureSize * n;
    // A Hammersley set, turned and shifted from vertex to vertex: what error remains has no form.
    const float turn = scattered(2 * vertex);
    const float shift = scattered(2 * vertex + 1);
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < m_rays; ++i) {
      const float share = (float(i) + shift) / float(m_rays);
      const float angle = 6.28318531f * (radicalInverse(std::uint32_t(i)) + turn);
      const float r = std::sqrt(share);
      const glm::vec3 d = r * std::cos(angle) * t + r * std::sin(angle) * u +
                          std::sqrt(std::max(0.0f, 1.0f - share)) * n;
      hidden += m_tree->blocked({.origin = origin, .direction = d}) ? 1 : 0;
    }
    return float(hidden) / float(m_rays);
  }

 private:
  const Surface& m_surface;
  BvhPtr m_tree;
  std::size_t m_rays;
};

/// Returns the vertices that triangles use, neighbours in space near each other.
std::vector<std::uint32_t> inSpatialOrder(const Surface& surface) {
  std::vector<char> seen(surface.mesh->vertexCount(), 0);
  std::vector<std::uint32_t> order;
  order.reserve(seen.size());
  for (const std::uint32_t triangle : spatialOrder(*surface.mesh))
    for (const std::uint32_t v : surface.mesh->triangles()[triangle])
      if (!seen[v]) {
        seen[v] = 1;
        order.push_back(v);
      }
  return order;
}

/// Returns a part of the vertices: every vertex has one of them at most so many edges away, and no
/// two of them are so near to each other.
std::vector<std::uint32_t> spread(const std::vector<std::uint32_t>& order, const VertexRings& rings,
                                  int apart) {
  std::vector<char> covered(rings.vertexCount(), 0);
  std::vector<std::uint32_t> reached(rings.vertexCount(),
                                     std::numeric_limits<std::uint32_t>::max());
  std::vector<std::uint32_t> chosen;
  std::vector<std::uint32_t> front;
  for (const std::uint32_t v : order) {
    if (covered[v])
      continue;
    chosen.push_back(v);
    front.assign(1, v);
    reached[v] = v;
    std::size_t begin = 0;
    for (int step = 0; step < apart; ++step)
      for (const std::size_t end = front.size(); begin < end; ++begin)
        for (const std::uint32_t other : rings[front[begin]])
          if (reached[other] != v) {
            reached[other] = v;
            front.push_back(other);
          }
    for (const std::uint32_t other : front)
      covered[other] = 1;
  }
  return chosen;
}

/// Returns how many edges apart rays start, so that about the wanted number of places do; 0: at
/// every vertex.
int edgesApart(std::size_t vertices) {
  int apart = 0;
  // Discs of so many edges have 1 + 3·n·(n + 1) vertices on a regular mesh; chosen one after the
  // other they overlap to two fifths.
  while (0.6 * (1.0 + 3.0 * apart * (apart + 1.0)) * double(mostPoints) < double(vertices) &&
         vertices > mostPoints)
    ++apart;
  return apart;
}

}  // namespace

std::vector<float> ambientOcclusion(const Surface& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<float> field(mesh.vertexCount(), 0.0f);
  if (mesh.triangleCount() == 0)
    return field;
  const HalfEdges edges(mesh.vertexCount(), mesh.triangles());
  const VertexRings rings(mesh.vertexCount(), mesh.triangles(), edges);
  const std::vector<std::uint32_t> order = inSpatialOrder(surface);
  const int apart = edgesApart(order.size());
  const std::vector<std::uint32_t> points = apart > 0 ? spread(order, rings, apart) : order;
  const Sky sky(surface, std::clamp(raysInAll / points.size(), fewestRays, mostRays));
  // What is known, and how much of it: the filter's quotient is the mean of what is near.
  std::vector<glm::vec2> known(mesh.vertexCount(), glm::vec2(0.0f));
  parallelFor(points.size(), 32, [&](std::size_t i) {
    known[points[i]] = {sky.hiddenAt(points[i]), 1.0f};
  });
  const float deviation = filterWidth * float(apart + 1);
  diffuse(rings, apart > 0 ? int(4.0f * deviation * deviation) : ownDiffusion, known);
  for (std::size_t v = 0; v < field.size(); ++v)
    field[v] = known[v].y > 0.0f ? std::clamp(known[v].x / known[v].y, 0.0f, 1.0f) : 0.0f;
  return field;
}

}  // namespace sline::model
