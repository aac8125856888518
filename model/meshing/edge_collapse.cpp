// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <queue>
#include <tuple>

namespace sline::model {

namespace {
constexpr std::uint32_t none = 0xffffffffu;

/// Σ area · (n·p + d)² as a polynomial in p.
struct Quadric {
  glm::dmat3 a{0.0};
  glm::dvec3 b{0.0};
  double c = 0.0;
  double area = 0.0;

  void add(const glm::dvec3& normal, double offset, double weight) {
    for (glm::length_t i = 0; i < 3; ++i)
      a[i] += weight * normal[i] * normal;
    b += weight * offset * normal;
    c += weight * offset * offset;
    area += weight;
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    area += other.area;
    return *this;
  }
  /// Root mean square distance from the planes.
  double distance(const glm::dvec3& p) const {
    const double sum = glm::dot(p, a * p) + 2.0 * glm::dot(b, p) + c;
    return area > 0.0 ? std::sqrt(std::max(0.0, sum) / area) : 0.0;
  }
  /// The best place, where the planes leave it open the one nearest to `near`.
  glm::dvec3 best(const glm::dvec3& near) const {
    const double weak = 1e-3 * area + 1e-30;
    const glm::dmat3 held = a + glm::dmat3(weak);
    return glm::inverse(held) * (weak * near - b);
  }
};

struct Candidate {
  double cost;
  std::uint32_t gone;
  std::uint32_t kept;
  std::uint32_t stamps;  ///< of both when it was computed
  glm::dvec3 place;
  bool operator<(const Candidate& other) const {
    // The queue hands out the largest; ties go by number, so that the result is always the same.
    return cost != other.cost ? cost > other.cost
                              : std::tie(gone, kept) > std::tie(other.gone, other.kept);
  }
};

class EdgeCollapse {
 public:
  EdgeCollapse(const Mesh& mesh, std::span<const float> tolerances)
      : m_centre(mesh.bounds().empty() ? glm::vec3(0.0f) : mesh.bounds().centre()),
        m_triangles(mesh.triangles().begin(), mesh.triangles().end()),
        m_tolerance(tolerances.begin(), tolerances.end()),
        m_faces(mesh.vertexCount()),
        m_quadrics(mesh.vertexCount()),
        m_fixed(mesh.vertexCount(), 0),
        m_stamps(mesh.vertexCount(), 0),
        m_dead(mesh.triangleCount(), 0) {
    m_places.reserve(mesh.vertexCount());
    for (const glm::vec3& p : mesh.positions())
      m_places.push_back(glm::dvec3(p) - m_centre);
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t)
      for (const std::uint32_t v : m_triangles[t])
        m_faces[v].push_back(t);
    addQuadrics();
    for (std::uint32_t v = 0; v < m_faces.size(); ++v)
      m_fixed[v] = ringOf(v) ? 0 : 1;
    for (const Triangle& t : m_triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] < t[(k + 1) % 3])
          offer(t[k], t[(k + 1) % 3]);
  }

  bool run(const std::function<bool()>& goesOn) {
    for (std::size_t step = 0; !m_queue.empty(); ++step) {
      if (step % 4096 == 0 && !goesOn())
        return false;
      const Candidate next = m_queue.top();
      m_queue.pop();
      if (m_stamps[next.gone] + m_stamps[next.kept] == next.stamps && keepsTopology(next) &&
          !turnsOver(next.gone, next) && !turnsOver(next.kept, next))
        collapse(next);
    }
    return true;
  }

  Collapsed result() const {
    Collapsed out;
    std::vector<std::uint32_t> index(m_places.size(), none);
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
      if (m_dead[t])
        continue;
      Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& v = index[m_triangles[t][k]];
        if (v == none) {
          v = std::uint32_t(out.positions.size());
          out.positions.push_back(glm::vec3(m_places[m_triangles[t][k]] + m_centre));
        }
        triangle[k] = v;
      }
      out.triangles.push_back(triangle);
    }
    return out;
  }

 private:
  static bool has(const Triangle& t, std::uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
  }

  void addQuadrics() {
    for (const Triangle& t : m_triangles) {
      const glm::dvec3& p = m_places[t[0]];
      const glm::dvec3 cross = glm::cross(m_places[t[1]] - p, m_places[t[2]] - p);
      const double twice = glm::length(cross);
      if (!(twice > 0.0))
        continue;
      const glm::dvec3 normal = cross / twice;
      for (const std::uint32_t v : t)
        m_quadrics[v].add(normal, -glm::dot(normal, p), 0.5 * twice);
    }
  }

  /// True where the triangles around it are one closed fan, each edge shared by two that agree
  /// about which side is outside.
  bool ringOf(std::uint32_t v) const {
    const std::vector<std::uint32_t>& faces = m_faces[v];
    if (faces.size() < 3)
      return false;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes;
    for (const std::uint32_t t : faces) {
      const Triangle& f = m_triangles[t];
      const std::size_t k = f[0] == v ? 0 : f[1] == v ? 1 : 2;
      spokes.emplace_back(f[(k + 1) % 3], f[(k + 2) % 3]);
      if (spokes.back().first == spokes.back().second || spokes.back().first == v)
        return false;
    }
    std::sort(spokes.begin(), spokes.end());
    std::uint32_t at = spokes.front().first;
    for (std::size_t step = 1; step <= spokes.size(); ++step) {
      const auto found = std::lower_bound(spokes.begin(), spokes.end(),
                                          std::pair<std::uint32_t, std::uint32_t>(at, 0));
      if (found == spokes.end() || found->first != at ||
          (found + 1 != spokes.end() && (found + 1)->first == at))
        return false;
      at = found->second;
      if (at == spokes.front().first)
        return step == spokes.size();
    }
    return false;
  }

  void offer(std::uint32_t gone, std::uint32_t kept) {
    if (m_fixed[gone] && m_fixed[kept])
      return;
    if (m_fixed[gone])
      std::swap(gone, kept);
    Quadric both = m_quadrics[gone];
    both += m_quadrics[kept];
    const glm::dvec3 middle = 0.5 * (m_places[gone] + m_places[kept]);
    Candidate candidate{0.0, gone, kept, m_stamps[gone] + m_stamps[kept],
                        m_fixed[kept] ? m_places[kept] : both.best(middle)};
    candidate.cost = both.distance(candidate.place);
    if (candidate.cost <= double(std::min(m_tolerance[gone], m_tolerance[kept])))
      m_queue.push(candidate);
  }

  std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t t : m_faces[v])
      for (const std::uint32_t w : m_triangles[t])
        if (w != v)
          ring.push_back(w);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  bool keepsTopology(const Candidate& c) const {
    const std::vector<std::uint32_t> a = neighbours(c.gone);
    const std::vector<std::uint32_t> b = neighbours(c.kept);
    std::vector<std::uint32_t> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2 || !std::binary_search(a.begin(), a.end(), c.kept))
      return false;
    // The two triangles at the edge go; a third corner with three triangles would be left with two.
    for (const std::uint32_t w : common)
      if (!m_fixed[w] && m_faces[w].size() <= 3)
        return false;
    const auto joins = [&](std::uint32_t v) {
      return std::any_of(m_faces[v].begin(), m_faces[v].end(), [&](std::uint32_t t) {
        return has(m_triangles[t], common[0]) && has(m_triangles[t], common[1]);
      });
    };
    return !(joins(c.gone) && joins(c.kept));
  }

  /// Looks at the triangles around `moved` that stay: turned by more than 75° or made a needle,
  /// they would show.
  bool turnsOver(std::uint32_t moved, const Candidate& c) const {
    const std::uint32_t other = moved == c.gone ? c.kept : c.gone;
    for (const std::uint32_t t : m_faces[moved]) {
      const Triangle& f = m_triangles[t];
      if (has(f, other))
        continue;
      std::array<glm::dvec3, 3> p{m_places[f[0]], m_places[f[1]], m_places[f[2]]};
      const glm::dvec3 before = glm::cross(p[1] - p[0], p[2] - p[0]);
      const double roundBefore = roundness(p, glm::length(before));
      p[f[0] == moved ? 0 : f[1] == moved ? 1 : 2] = c.place;
      const glm::dvec3 after = glm::cross(p[1] - p[0], p[2] - p[0]);
      const double roundAfter = roundness(p, glm::length(after));
      if (glm::dot(before, after) < 0.25 * glm::length(before) * glm::length(after))
        return true;
      if (!(roundAfter > std::min(0.1, 0.5 * roundBefore)))
        return true;
    }
    return false;
  }

  /// 1 for an equilateral triangle, 0 without area.
  static double roundness(const std::array<glm::dvec3, 3>& p, double twiceArea) {
    const glm::dvec3 e[] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    const double squares = glm::dot(e[0], e[0]) + glm::dot(e[1], e[1]) + glm::dot(e[2], e[2]);
    return squares > 0.0 ? 2.0 * std::sqrt(3.0) * twiceArea / squares : 0.0;
  }

  void collapse(const Candidate& c) {
    for (const std::uint32_t t : m_faces[c.gone]) {
      Triangle& f = m_triangles[t];
      if (has(f, c.kept)) {
        m_dead[t] = 1;
        for (const std::uint32_t v : f)
          if (v != c.gone)
            std::erase(m_faces[v], t);
        continue;
      }
      std::replace(f.begin(), f.end(), c.gone, c.kept);
      m_faces[c.kept].push_back(t);
    }
    m_faces[c.gone] = {};
    m_places[c.kept] = c.place;
    m_quadrics[c.kept] += m_quadrics[c.gone];
    m_tolerance[c.kept] = std::min(m_tolerance[c.kept], m_tolerance[c.gone]);
    ++m_stamps[c.gone];
    ++m_stamps[c.kept];
    for (const std::uint32_t v : neighbours(c.kept))
      offer(std::min(v, c.kept), std::max(v, c.kept));
  }

  glm::dvec3 m_centre;
  std::vector<glm::dvec3> m_places;  ///< from the centre, so that squares keep their digits
  std::vector<Triangle> m_triangles;
  std::vector<float> m_tolerance;
  std::vector<std::vector<std::uint32_t>> m_faces;  ///< of each vertex
  std::vector<Quadric> m_quadrics;
  std::vector<char> m_fixed;
  std::vector<std::uint32_t> m_stamps;  ///< how often the vertex has changed
  std::vector<char> m_dead;             ///< of each triangle
  std::priority_queue<Candidate> m_queue;
};
}  // namespace

Collapsed withEdgesCollapsed(const Mesh& mesh, std::span<const float> tolerances,
                             const std::function<bool()>& goesOn) {
  EdgeCollapse collapse(mesh, tolerances);
  return collapse.run(goesOn) ? collapse.result() : Collapsed();
}

}  // namespace sline::model
