// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/remesh.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

namespace sline::model {

namespace {
using Vertex = std::uint32_t;

/// Lists the triangles of each vertex, compressed. Mesh and VertexFaces would copy the positions.
class Stars {
 public:
  explicit Stars(const Facets& facets) : m_first(facets.positions.size() + 1, 0) {
    for (const Triangle& t : facets.triangles)
      for (const Vertex v : t)
        ++m_first[v + 1];
    for (std::size_t v = 1; v < m_first.size(); ++v)
      m_first[v] += m_first[v - 1];
    m_faces.resize(3 * facets.triangles.size());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t f = 0; f < facets.triangles.size(); ++f)
      for (const Vertex v : facets.triangles[f])
        m_faces[next[v]++] = std::uint32_t(f);
  }
  std::span<const std::uint32_t> operator[](Vertex v) const {
    return {m_faces.data() + m_first[v], m_faces.data() + m_first[v + 1]};
  }

 private:
  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_faces;
};

/// Returns the corner after v, counter-clockwise.
Vertex after(const Triangle& t, Vertex v) {
  return t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
}
Vertex before(const Triangle& t, Vertex v) {
  return t[0] == v ? t[2] : t[1] == v ? t[0] : t[1];
}

glm::vec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(b - a, c - a);
}

/// Tells whether both have a direction, and nearly the same one.
bool agree(const glm::vec3& a, const glm::vec3& b, float cosine) {
  const float lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0f && glm::dot(a, b) > cosine * lengths;
}

class Collapse {
 public:
  Collapse(Facets& facets, float shortest, float longest)
      : m_facets(facets),
        m_stars(facets),
        m_busy(facets.positions.size(), false),
        m_shortest(shortest),
        m_longest(longest) {}

  void run() {
    for (Vertex a = 0; a < m_facets.positions.size(); ++a)
      for (const std::uint32_t f : m_stars[a]) {
        if (m_busy[a])
          break;
        const Vertex b = after(m_facets.triangles[f], a);
        if (a < b && glm::distance(at(a), at(b)) < m_shortest && mayMeet(a, b))
          meet(a, b);
      }
    tidy();
  }

 private:
  const glm::vec3& at(Vertex v) const { return m_facets.positions[v]; }

  /// Tells whether the vertices may be merged while the surface stays one: exactly the two
  /// triangles at the edge vanish, and no vertex is left with fewer than four.
  bool mayMeet(Vertex a, Vertex b) const {
    int shared = 0;
    for (const std::uint32_t f : m_stars[a]) {
      const Vertex v = after(m_facets.triangles[f], a);
      if (m_busy[v])
        return false;
      for (const std::uint32_t g : m_stars[b])
        if (after(m_facets.triangles[g], b) == v) {
          ++shared;
          if (m_stars[v].size() < 5)
            return false;
        }
    }
    for (const std::uint32_t g : m_stars[b])
      if (m_busy[after(m_facets.triangles[g], b)])
        return false;
    const glm::vec3 middle = 0.5f * (at(a) + at(b));
    return shared == 2 && staysFlat(a, b, middle) && staysFlat(b, a, middle);
  }

  bool staysFlat(Vertex moved, Vertex other, const glm::vec3& to) const {
    for (const std::uint32_t f : m_stars[moved]) {
      const Vertex b = after(m_facets.triangles[f], moved);
      const Vertex c = before(m_facets.triangles[f], moved);
      if (b == other || c == other)
        continue;
      if (glm::distance(at(b), to) > m_longest ||
          !agree(areaNormal(at(moved), at(b), at(c)), areaNormal(to, at(b), at(c)), 0.8f))
        return false;
    }
    return true;
  }

  void meet(Vertex a, Vertex b) {
    for (const Vertex v : {a, b})
      for (const std::uint32_t f : m_stars[v])
        for (const Vertex corner : m_facets.triangles[f])
          m_busy[corner] = true;
    m_facets.positions[a] = 0.5f * (at(a) + at(b));
    for (const std::uint32_t f : m_stars[b]) {
      Triangle& t = m_facets.triangles[f];
      if (after(t, b) == a || before(t, b) == a)
        t = {0, 0, 0};
      else
        std::replace(t.begin(), t.end(), b, a);
    }
  }

  void tidy() {
    std::erase_if(m_facets.triangles, [](const Triangle& t) { return t[0] == t[1]; });
    std::vector<Vertex> renamed(m_facets.positions.size(), 0);
    for (const Triangle& t : m_facets.triangles)
      for (const Vertex v : t)
        renamed[v] = 1;
    Vertex count = 0;
    for (std::size_t v = 0; v < renamed.size(); ++v)
      if (renamed[v] != 0) {
        m_facets.positions[count] = m_facets.positions[v];
        renamed[v] = count++;
      }
    m_facets.positions.resize(count);
    for (Triangle& t : m_facets.triangles)
      for (Vertex& v : t)
        v = renamed[v];
  }

  Facets& m_facets;
  Stars m_stars;
  std::vector<bool> m_busy;
  float m_shortest;
  float m_longest;
};

class Turn {
 public:
  explicit Turn(Facets& facets)
      : m_facets(facets), m_stars(facets), m_busy(facets.positions.size(), false) {}

  void run() {
    for (Vertex a = 0; a < m_facets.positions.size(); ++a)
      for (const std::uint32_t f : m_stars[a]) {
        if (m_busy[a])
          break;
        if (a < after(m_facets.triangles[f], a))
          consider(a, f);
      }
  }

 private:
  const glm::vec3& at(Vertex v) const { return m_facets.positions[v]; }

  /// Returns the squared difference from six if the vertex had `more` triangles.
  int unevenness(Vertex v, int more) const {
    const int off = int(m_stars[v].size()) + more - 6;
    return off * off;
  }

  void consider(Vertex a, std::uint32_t f) {
    const Vertex b = after(m_facets.triangles[f], a);
    const Vertex c = before(m_facets.triangles[f], a);
    const auto twin = std::find_if(m_stars[a].begin(), m_stars[a].end(), [&](std::uint32_t g) {
      return before(m_facets.triangles[g], a) == b;
    });
    if (twin == m_stars[a].end())
      return;
    const Vertex d = after(m_facets.triangles[*twin], a);
    if (m_busy[b] || m_busy[c] || m_busy[d])
      return;
    const int now = unevenness(a, 0) + unevenness(b, 0) + unevenness(c, 0) + unevenness(d, 0);
    const int then = unevenness(a, -1) + unevenness(b, -1) + unevenness(c, 1) + unevenness(d, 1);
    if (then >= now || m_stars[a].size() < 5 || m_stars[b].size() < 5 || !flat(a, b, c, d) ||
        neighbours(c, d))
      return;
    m_facets.triangles[f] = {a, d, c};
    m_facets.triangles[*twin] = {d, b, c};
    for (const Vertex v : {a, b, c, d})
      m_busy[v] = true;
  }

  bool flat(Vertex a, Vertex b, Vertex c, Vertex d) const {
    const glm::vec3 f = areaNormal(at(a), at(b), at(c));
    const glm::vec3 g = areaNormal(at(b), at(a), at(d));
    return agree(f, g, 0.8f) && agree(areaNormal(at(a), at(d), at(c)), f + g, 0.85f) &&
           agree(areaNormal(at(d), at(b), at(c)), f + g, 0.85f);
  }

  bool neighbours(Vertex c, Vertex d) const {
    return std::any_of(m_stars[c].begin(), m_stars[c].end(), [&](std::uint32_t g) {
      const Triangle& t = m_facets.triangles[g];
      return t[0] == d || t[1] == d || t[2] == d;
    });
  }

  Facets& m_facets;
  Stars m_stars;
  std::vector<bool> m_busy;
};
}  // namespace

void drawTogether(Facets& facets, float shortest, float longest) {
  Collapse(facets, shortest, longest).run();
}

void turnEdges(Facets& facets) {
  Turn(facets).run();
}

}  // namespace sline::model
