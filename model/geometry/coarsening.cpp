// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/coarsening.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "model/geometry/cluster_order.h"
#include "model/geometry/spatial_order.h"

namespace sline::model {

namespace {

/// Stretches of so many triangles are coarsened at the same time, each by itself: what lies on the
/// border of two waits for the next round, in which they begin elsewhere.
constexpr std::size_t trianglesOfStretch = 1U << 15U;
constexpr int rounds = 2;
constexpr int mostSweeps = 6;
/// A vertex has so many triangles at most; those that have more stay where they are.
constexpr std::size_t mostFaces = 12;
/// One that has no more keeps them.
constexpr std::size_t leastFaces = 4;
/// An edge may become so long, in units of what is asked for.
constexpr float longestEdge = 1.8f;
/// What is left out may lie so far from what takes its place, in units of what is asked for.
constexpr float farthest = 0.2f;
/// The least cosine between a triangle's normals before and after a vertex moved.
constexpr float leastTurn = 0.7f;
/// The least height of a new triangle in units of its longest edge (an even one has 0.87), unless
/// the old one's was no more. With 0.3 a mesh of squares could not be coarsened at all.
constexpr float leastHeight = 0.2f;

/// Numbers the vertices of a stretch in the order in which they come.
class StretchVertices {
 public:
  /// There are three vertices a triangle at most, where none share any.
  explicit StretchVertices(std::size_t triangles)
      : m_slots(std::bit_ceil(3 * triangles + 1), none) {}

  /// Returns the vertex' number.
  std::uint32_t of(std::uint32_t vertex) {
    const std::size_t mask = m_slots.size() - 1;
    for (std::size_t at = (std::size_t(vertex) * 0x9e3779b1U) & mask;; at = (at + 1) & mask) {
      std::uint32_t& slot = m_slots[at];
      if (slot == none) {
        slot = std::uint32_t(m_vertices.size());
        m_vertices.push_back(vertex);
      }
      if (m_vertices[slot] == vertex)
        return slot;
    }
  }
  const std::vector<std::uint32_t>& vertices() const { return m_vertices; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> m_slots;
  std::vector<std::uint32_t> m_vertices;
};

/// The triangles around a vertex, none twice.
struct Fan {
  std::array<std::uint16_t, mostFaces> faces{};
  std::uint8_t count = 0;
  bool fixed = false;    ///< the vertex stays: more triangles may hang on it than these
  bool settled = false;  ///< it was tried in vain, and nothing beside it has changed since

  void add(std::uint16_t face) {
    if (count == mostFaces)
      fixed = true;
    else
      faces[count++] = face;
  }
  void remove(std::uint16_t face) {
    for (std::size_t i = 0; i < count; ++i)
      if (faces[i] == face) {
        faces[i] = faces[--count];
        return;
      }
  }
};

/// The edges opposite a vertex in its triangles: from[i] to to[i], in the order of its fan.
struct Ring {
  std::array<std::uint32_t, mostFaces> from{};
  std::array<std::uint32_t, mostFaces> to{};
  std::size_t count = 0;
};

/// A triangle as it is looked at from one of its corners.
struct Corner {
  glm::vec3 normal;
  float area;  ///< twice that, the length of the normal
  float longest;

  Corner(const glm::vec3& at, const glm::vec3& a, const glm::vec3& b)
      : normal(glm::cross(a - at, b - at)),
        area(glm::length(normal)),
        longest(std::max({glm::length(a - at), glm::length(b - at), glm::length(b - a)})) {}
  /// Returns its height in units of the longest edge; 0 where it has no size.
  float height() const { return longest > 0.0f ? area / (longest * longest) : 0.0f; }
};

class Coarsener {
 public:
  Coarsener(std::span<const glm::vec3> positions, std::span<const Triangle> triangles, float edge);

  /// Returns the triangles that are left.
  std::vector<Triangle> run();

 private:
  struct Neighbour {
    std::uint32_t vertex;
    float distance;
  };

  /// Fixes vertices whose triangles are no closed fan.
  void findFixed();
  Ring ringOf(std::uint32_t v) const;
  /// Takes the vertex out if one of its edges is short enough and may be collapsed.
  bool takeOut(std::uint32_t v);
  /// Tells whether v may become u as far as connectivity goes.
  bool mayJoin(const Ring& ring, std::uint32_t u) const;
  /// Returns how far v lies off when it becomes u; negative where triangles would turn too far or
  /// be too long or thin.
  float offset(std::uint32_t v, const Ring& ring, std::uint32_t u) const;
  void join(std::uint32_t v, const Ring& ring, std::uint32_t u);
  bool adjacent(std::uint32_t a, std::uint32_t b) const;

  float m_edge;
  StretchVertices m_numbers;
  std::vector<Triangle> m_triangles;  ///< of local numbers; those left out are all zero
  std::vector<glm::vec3> m_positions;
  std::vector<Fan> m_fans;
  std::vector<float> m_offsets;  ///< how far what became the vertex lies off
};

Coarsener::Coarsener(std::span<const glm::vec3> positions, std::span<const Triangle> triangles,
                     float edge)
    : m_edge(edge), m_numbers(triangles.size()) {
  m_triangles.reserve(triangles.size());
  for (const Triangle& t : triangles)
    m_triangles.push_back({m_numbers.of(t[0]), m_numbers.of(t[1]), m_numbers.of(t[2])});
  const std::vector<std::uint32_t>& vertices = m_numbers.vertices();
  m_positions.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices)
    m_positions.push_back(positions[vertex]);
  m_fans.resize(vertices.size());
  m_offsets.resize(vertices.size(), 0.0f);
  for (std::size_t i = 0; i < m_triangles.size(); ++i)
    for (const std::uint32_t corner : m_triangles[i])
      m_fans[corner].add(std::uint16_t(i));
}

Ring Coarsener::ringOf(std::uint32_t v) const {
  Ring ring;
  const Fan& fan = m_fans[v];
  ring.count = fan.count;
  for (std::size_t i = 0; i < fan.count; ++i) {
    const Triangle& t = m_triangles[fan.faces[i]];
    const std::size_t at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    ring.from[i] = t[(at + 1) % 3];
    ring.to[i] = t[(at + 2) % 3];
  }
  return ring;
}

void Coarsener::findFixed() {
  for (std::uint32_t v = 0; v < m_fans.size(); ++v) {
    if (m_fans[v].fixed)
      continue;
    // Each neighbour ends one edge of the ring and begins another, and all are one loop.
    const Ring ring = ringOf(v);
    std::size_t steps = 0;
    std::uint32_t at = ring.count ? ring.from[0] : v;
    do {
      const auto begin = ring.from.begin();
      const auto end = begin + std::ptrdiff_t(ring.count);
      const auto next = std::find(begin, end, at);
      if (next == end || std::find(next + 1, end, at) != end || ++steps > ring.count)
        break;
      at = ring.to[std::size_t(next - begin)];
    } while (at != ring.from[0]);
    m_fans[v].fixed = steps < 3 || steps != ring.count || at != ring.from[0];
  }
}

bool Coarsener::adjacent(std::uint32_t a, std::uint32_t b) const {
  const Fan& fan = m_fans[a];
  return std::any_of(fan.faces.begin(), fan.faces.begin() + fan.count, [&](std::uint16_t face) {
    const Triangle& t = m_triangles[face];
    return t[0] == b || t[1] == b || t[2] == b;
  });
}

bool Coarsener::mayJoin(const Ring& ring, std::uint32_t u) const {
  const Fan& target = m_fans[u];
  // Two triangles go, each of which both vertices have.
  if (target.count + ring.count > mostFaces + 4)
    return false;
  std::uint32_t before = u;  // the ring's vertices beside u
  std::uint32_t after = u;
  for (std::size_t i = 0; i < ring.count; ++i) {
    if (ring.to[i] == u)
      before = ring.from[i];
    if (ring.from[i] == u)
      after = ring.to[i];
  }
  for (std::size_t i = 0; i < ring.count; ++i) {
    const std::uint32_t w = ring.from[i];
    const Fan& fan = m_fans[w];
    if (w == before || w == after) {
      if (!fan.fixed && fan.count <= leastFaces)
        return false;
    } else if (w != u && (fan.fixed ? target.fixed || adjacent(u, w) : adjacent(w, u))) {
      // Fixed ones may be joined by a triangle that is not of this stretch.
      return false;
    }
  }
  return true;
}

float Coarsener::offset(std::uint32_t v, const Ring& ring, std::uint32_t u) const {
  const glm::vec3& old = m_positions[v];
  const glm::vec3& place = m_positions[u];
  float off = 0.0f;
  for (std::size_t i = 0; i < ring.count; ++i) {
    if (ring.from[i] == u || ring.to[i] == u)
      continue;
    const glm::vec3& a = m_positions[ring.from[i]];
    const glm::vec3& b = m_positions[ring.to[i]];
    const Corner before(old, a, b);
    const Corner after(place, a, b);
    if (!(after.area > 0.0f) || after.longest > longestEdge * m_edge ||
        after.height() < std::min(leastHeight, before.height()) ||
        glm::dot(before.normal, after.normal) < leastTurn * before.area * after.area)
      return -1.0f;
    off = std::max(off, std::abs(glm::dot(after.normal, old - place)) / after.area);
  }
  off += m_offsets[v];
  return off <= farthest * m_edge ? off : -1.0f;
}

void Coarsener::join(std::uint32_t v, const Ring& ring, std::uint32_t u) {
  const Fan fan = m_fans[v];
  for (std::size_t i = 0; i < fan.count; ++i) {
    const std::uint16_t face = fan.faces[i];
    if (ring.from[i] == u || ring.to[i] == u) {
      m_fans[ring.from[i]].remove(face);
      m_fans[ring.to[i]].remove(face);
      m_triangles[face] = {};
    } else {
      for (std::uint32_t& corner : m_triangles[face])
        if (corner == v)
          corner = u;
    }
  }
  // Room for the new triangles is there once the two are gone.
  for (std::size_t i = 0; i < fan.count; ++i)
    if (ring.from[i] != u && ring.to[i] != u)
      m_fans[u].add(fan.faces[i]);
  for (std::size_t i = 0; i < ring.count; ++i)
    m_fans[ring.from[i]].settled = false;
  m_fans[v] = {.faces = {}, .count = 0, .fixed = true};
}

bool Coarsener::takeOut(std::uint32_t v) {
  if (m_fans[v].fixed || m_fans[v].settled)
    return false;
  m_fans[v].settled = true;
  const Ring ring = ringOf(v);
  std::array<Neighbour, mostFaces> near{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.count; ++i)
    if (const float d = glm::distance(m_positions[v], m_positions[ring.from[i]]); d < m_edge)
      near[count++] = {ring.from[i], d};
  std::sort(near.begin(), near.begin() + std::ptrdiff_t(count),
            [](const Neighbour& a, const Neighbour& b) { return a.distance < b.distance; });
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t u = near[i].vertex;
    if (!mayJoin(ring, u))
      continue;
    const float off = offset(v, ring, u);
    if (off < 0.0f)
      continue;
    join(v, ring, u);
    m_offsets[u] = std::max(m_offsets[u], off);
    return true;
  }
  return false;
}

std::vector<Triangle> Coarsener::run() {
  findFixed();
  bool changed = true;
  for (int sweep = 0; changed && sweep < mostSweeps; ++sweep) {
    changed = false;
    for (std::uint32_t v = 0; v < m_fans.size(); ++v)
      changed = takeOut(v) || changed;
  }
  const std::vector<std::uint32_t>& vertices = m_numbers.vertices();
  std::vector<Triangle> kept;
  kept.reserve(m_triangles.size());
  for (const Triangle& t : m_triangles)
    if (t[0] != t[1])
      kept.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  return kept;
}

/// Coarsens the triangles in stretches of which the first has `first`.
std::vector<Triangle> oneRound(const Mesh& mesh, const std::vector<Triangle>& triangles,
                               std::size_t first, float edge) {
  const std::size_t count =
      1 + (triangles.size() - std::min(first, triangles.size()) + trianglesOfStretch - 1) /
              trianglesOfStretch;
  std::vector<std::vector<Triangle>> parts(count);
  parallelFor(count, 1, [&](std::size_t i) {
    const std::size_t begin =
        i == 0 ? 0 : std::min(first + (i - 1) * trianglesOfStretch, triangles.size());
    const std::size_t end = std::min(first + i * trianglesOfStretch, triangles.size());
    if (begin < end)
      parts[i] =
          Coarsener(mesh.positions(), std::span(triangles).subspan(begin, end - begin), edge).run();
  });
  std::size_t size = 0;
  for (const auto& part : parts)
    size += part.size();
  std::vector<Triangle> left;
  left.reserve(size);
  for (const auto& part : parts)
    left.insert(left.end(), part.begin(), part.end());
  return left;
}

/// Returns the mesh of these triangles, without vertices that none uses.
CoarserMesh meshOf(const Mesh& mesh, std::vector<Triangle> triangles) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> numbers(mesh.vertexCount(), unused);
  std::vector<std::uint32_t> vertices;
  vertices.reserve(triangles.size() / 2 + 3);
  for (Triangle& t : triangles)
    for (std::uint32_t& corner : t) {
      std::uint32_t& number = numbers[corner];
      if (number == unused) {
        number = std::uint32_t(vertices.size());
        vertices.push_back(corner);
      }
      corner = number;
    }
  std::vector<glm::vec3> positions(vertices.size());
  std::transform(vertices.begin(), vertices.end(), positions.begin(),
                 [&](std::uint32_t v) { return mesh.positions()[v]; });
  Result<Mesh> made = Mesh::create(std::move(positions), std::move(triangles));
  return {std::make_shared<const Mesh>(std::move(*made)), std::move(vertices)};
}

}  // namespace

std::vector<Triangle> coarsenedTriangles(const Mesh& mesh, float edge) {
  std::vector<Triangle> triangles;
  {
    const std::vector<std::uint32_t> order = spatialOrder(mesh);
    triangles.resize(order.size());
    std::transform(order.begin(), order.end(), triangles.begin(),
                   [&](std::uint32_t t) { return mesh.triangles()[t]; });
  }
  for (int round = 0; round < rounds; ++round)
    triangles =
        oneRound(mesh, triangles, round % 2 ? trianglesOfStretch / 2 : trianglesOfStretch, edge);
  return triangles;
}

CoarserMesh coarsened(const Mesh& mesh, float edge) {
  std::vector<Triangle> triangles = coarsenedTriangles(mesh, edge);
  return triangles.size() == mesh.triangleCount() ? CoarserMesh{}
                                                  : meshOf(mesh, std::move(triangles));
}

Mesh meshBetween(const Surface& surface, std::vector<Triangle> triangles) {
  const auto positions = surface.mesh->positions();
  Result<Mesh> made = Mesh::create({positions.begin(), positions.end()}, std::move(triangles));
  return std::move(*made);
}

namespace {

std::vector<float> cornersOf(const Clusters& clusters, const Surface& surface) {
  std::vector<float> corners(Clusters::cornerRows * clusters.vertices.size());
  for (const Cluster& cluster : clusters.items) {
    float* rows = corners.data() + Clusters::cornerRows * cluster.firstVertex;
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
      const std::uint32_t vertex = clusters.vertices[cluster.firstVertex + i];
      const glm::vec3 position = surface.mesh->positions()[vertex];
      const glm::vec3 normal = surface.normals[vertex];
      for (int axis = 0; axis < 3; ++axis) {
        rows[std::size_t(axis) * cluster.vertexCount + i] = position[axis];
        rows[std::size_t(axis + 3) * cluster.vertexCount + i] = normal[axis];
      }
    }
  }
  return corners;
}

}  // namespace

Clusters clustersBetween(const Surface& surface, std::vector<Triangle> triangles) {
  const Mesh mesh = meshBetween(surface, std::move(triangles));
  Clusters clusters = buildClusters(mesh, clusterOrder(mesh), surface.vertices.all());
  clusters.triangles = {};
  clusters.samples = {};
  clusters.groups = {};
  clusters.corners = cornersOf(clusters, surface);
  return clusters;
}

}  // namespace sline::model
