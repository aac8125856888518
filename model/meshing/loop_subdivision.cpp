// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/loop_subdivision.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/base/parallel.h"
#include "model/fairing/half_edges.h"

namespace sline::model {

namespace {

/// Collects what the old vertices need from their surroundings.
struct Gathered {
  std::vector<glm::vec3> inner;        ///< sum over neighbours
  std::vector<std::uint16_t> valence;  ///< number of neighbours along edges
  std::vector<glm::vec3> border;       ///< sum over neighbours along border edges
  std::vector<std::uint16_t> borders;  ///< number of border edges
};

double loopBeta(double valence) {
  const double c = 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi / valence);
  return (0.625 - c * c) / valence;
}

class LoopStep {
 public:
  LoopStep(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles)
      : m_positions(positions), m_triangles(triangles), m_edges(positions.size(), triangles) {}

  Subdivided run() {
    Subdivided result;
    moveOldVertices(result);
    m_edgeVertex.assign(m_edges.count(), 0);
    addEdgeVertices(result);
    result.triangles.reserve(m_triangles.size() * 4);
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
      const Triangle& v = m_triangles[t];
      const std::uint32_t ab = m_edgeVertex[3 * t];
      const std::uint32_t bc = m_edgeVertex[3 * t + 1];
      const std::uint32_t ca = m_edgeVertex[3 * t + 2];
      result.triangles.insert(result.triangles.end(),
                              {Triangle{v[0], ab, ca}, Triangle{v[1], bc, ab},
                               Triangle{v[2], ca, bc}, Triangle{ab, bc, ca}});
    }
    return result;
  }

 private:
  std::uint32_t from(std::uint32_t h) const { return m_triangles[h / 3][h % 3]; }
  std::uint32_t to(std::uint32_t h) const { return from(nextInTriangle(h)); }
  /// Returns the corner of the half-edge's triangle that lies opposite the edge.
  std::uint32_t across(std::uint32_t h) const { return to(nextInTriangle(h)); }
  bool first(std::uint32_t h) const { return !m_edges.hasOpposite(h) || m_edges.opposite(h) > h; }

  Gathered gather() const {
    const std::size_t count = m_positions.size();
    Gathered g{std::vector<glm::vec3>(count, glm::vec3(0.0f)), std::vector<std::uint16_t>(count, 0),
               std::vector<glm::vec3>(count, glm::vec3(0.0f)),
               std::vector<std::uint16_t>(count, 0)};
    for (std::uint32_t h = 0; h < m_edges.count(); ++h) {
      if (!first(h))
        continue;
      const std::uint32_t a = from(h);
      const std::uint32_t b = to(h);
      g.inner[a] += m_positions[b];
      g.inner[b] += m_positions[a];
      ++g.valence[a];
      ++g.valence[b];
      if (m_edges.hasOpposite(h))
        continue;
      // An edge of many triangles counts as several borders, which fixes its ends.
      g.border[a] += m_positions[b];
      g.border[b] += m_positions[a];
      ++g.borders[a];
      ++g.borders[b];
    }
    return g;
  }

  void moveOldVertices(Subdivided& result) const {
    const Gathered g = gather();
    result.positions.reserve(m_positions.size() + m_edges.count() / 2 + m_edges.openCount());
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
      const glm::vec3& p = m_positions[v];
      if (g.borders[v] == 2) {
        result.positions.push_back(0.75f * p + 0.125f * g.border[v]);
      } else if (g.borders[v] > 0 || g.valence[v] < 3) {
        result.positions.push_back(p);
      } else {
        const float n = g.valence[v];
        const float beta = float(loopBeta(n));
        result.positions.push_back((1.0f - n * beta) * p + beta * g.inner[v]);
      }
    }
  }

  void addEdgeVertices(Subdivided& result) {
    for (std::uint32_t h = 0; h < m_edges.count(); ++h) {
      if (!first(h)) {
        m_edgeVertex[h] = m_edgeVertex[m_edges.opposite(h)];
        continue;
      }
      const glm::vec3 ends = m_positions[from(h)] + m_positions[to(h)];
      m_edgeVertex[h] = std::uint32_t(result.positions.size());
      if (m_edges.hasOpposite(h))
        result.positions.push_back(
            0.375f * ends +
            0.125f * (m_positions[across(h)] + m_positions[across(m_edges.opposite(h))]));
      else
        result.positions.push_back(0.5f * ends);
    }
  }

  const std::vector<glm::vec3>& m_positions;
  const std::vector<Triangle>& m_triangles;
  HalfEdges m_edges;
  std::vector<std::uint32_t> m_edgeVertex;
};

}  // namespace

Subdivided loopSubdivided(const std::vector<glm::vec3>& positions,
                          const std::vector<Triangle>& triangles) {
  return LoopStep(positions, triangles).run();
}

std::vector<glm::vec3> limitPositions(const std::vector<glm::vec3>& positions,
                                      const VertexRings& rings) {
  std::vector<glm::vec3> limit = positions;
  parallelFor(positions.size(), 16384, [&](std::size_t v) {
    const auto ring = rings[v];
    if (rings.onBorder(v) || ring.size() < 3)
      return;
    glm::vec3 sum(0.0f);
    for (const std::uint32_t other : ring)
      sum += positions[other];
    // This is the limit of an inner vertex (Loop 1987, §4).
    const float n = float(ring.size());
    const float chi = float(1.0 / (3.0 / (8.0 * loopBeta(n)) + n));
    limit[v] = (1.0f - n * chi) * positions[v] + chi * sum;
  });
  return limit;
}

std::vector<glm::vec3> interpolatingControl(const std::vector<glm::vec3>& positions,
                                            const VertexRings& rings) {
  constexpr int rounds = 6;
  std::vector<glm::vec3> control = positions;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<glm::vec3> limit = limitPositions(control, rings);
    for (std::size_t v = 0; v < positions.size(); ++v)
      control[v] += positions[v] - limit[v];
  }
  return control;
}

float farthestMove(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& after) {
  float farthest = 0.0f;
  for (std::size_t v = 0; v < std::min(before.size(), after.size()); ++v)
    farthest = std::max(farthest, glm::distance(before[v], after[v]));
  return farthest;
}

}  // namespace sline::model
