// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/surface/excluded_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_map>

namespace sline::model {

namespace {

/// Holds a distance to the accessible surface and the point of it that is nearest.
struct Nearest {
  double distance;
  glm::dvec3 foot{0.0, 0.0, 0.0};
};

/// Returns how far from the accessible surface distances are wanted.
double reachOf(double spacing) {
  return probeRadius + 1.01 * spacing;
}

class ProbeField : public LocalField {
 public:
  ProbeField(const SolventAccessible& surface, std::vector<std::uint32_t> balls, double spacing)
      : m_surface(surface), m_balls(std::move(balls)), m_spacing(spacing) {}

  void addArcs(const glm::dvec3& low, const glm::dvec3& high) {
    for (const std::uint32_t ball : m_balls)
      for (const ExposedArc& arc : m_surface.arcsOf(ball)) {
        const glm::dvec3 off = arc.centre - glm::clamp(arc.centre, low, high);
        if (glm::length(off) > arc.radius + m_reach)
          continue;
        const glm::dvec3 axis = glm::cross(arc.u, arc.v);
        m_arcs.push_back({&arc, axis});
        if (!arc.isWhole())
          for (const auto& [from, to] : arc.spans)
            for (const double angle : {from, to})
              m_corners.push_back(arc.centre +
                                  arc.radius * (std::cos(angle) * arc.u + std::sin(angle) * arc.v));
      }
  }

  /// Returns how deep p lies in the ball that covers it most; negative outside all.
  double depth(const glm::dvec3& p) const { return deepest(p).first; }

  FieldPoint at(const glm::dvec3& p) const override {
    Nearest nearest = nearestTo(p);
    FieldPoint result{nearest.distance - probeRadius, p};
    if (std::abs(result.value) > 0.5 * m_spacing)
      return result;
    // The walk goes from the foot inwards by the probe's radius; where the foot changes on the way
    // (a crease), it starts again from there.
    for (int i = 0; i < 3 && std::abs(nearest.distance - probeRadius) > 1e-7; ++i) {
      const double length = glm::length(result.onSurface - nearest.foot);
      if (nearest.distance >= m_reach || !(length > 1e-9))
        break;
      const glm::dvec3 inward = (result.onSurface - nearest.foot) / nearest.distance;
      result.onSurface = nearest.foot + probeRadius * inward;
      nearest = nearestTo(result.onSurface);
    }
    return result;
  }

 private:
  struct Arc {
    const ExposedArc* arc;
    glm::dvec3 axis;
  };

  std::pair<double, std::uint32_t> deepest(const glm::dvec3& p) const {
    std::pair<double, std::uint32_t> most(-1e30, 0);
    for (const std::uint32_t i : m_balls) {
      const Ball& ball = m_surface.balls()[i];
      const double deep = ball.radius - glm::length(p - ball.centre);
      if (deep > most.first)
        most = {deep, i};
    }
    return most;
  }

  /// Returns the signed distance, positive inside the union. The ball around p of the depth of the
  /// deepest ball lies in the union, so where that ball's sphere is free at the foot, nothing is
  /// nearer; elsewhere an arc or corner is.
  Nearest nearestTo(const glm::dvec3& p) const {
    const auto [deep, index] = deepest(p);
    if (deep >= m_reach)
      return {m_reach};
    const Ball& ball = m_surface.balls()[index];
    const glm::dvec3 out = p - ball.centre;
    const double length = glm::length(out);
    const glm::dvec3 foot = length > 0.0 ? ball.centre + (ball.radius / length) * out : ball.centre;
    if (deep <= 0.0 || (m_surface.isExposed(index) && m_surface.isFree(foot, index)))
      return {deep, foot};
    Nearest nearest{m_reach};
    nearestCorner(p, nearest);
    nearestArc(p, nearest);
    return nearest;
  }

  void nearestCorner(const glm::dvec3& p, Nearest& nearest) const {
    double least = nearest.distance * nearest.distance;
    for (const glm::dvec3& corner : m_corners) {
      const glm::dvec3 off = p - corner;
      const double squared = glm::dot(off, off);
      if (squared < least) {
        least = squared;
        nearest.foot = corner;
      }
    }
    nearest.distance = std::sqrt(least);
  }

  void nearestArc(const glm::dvec3& p, Nearest& nearest) const {
    double least = nearest.distance * nearest.distance;
    for (const Arc& one : m_arcs) {
      const ExposedArc& arc = *one.arc;
      const glm::dvec3 off = p - arc.centre;
      const double axial = glm::dot(off, one.axis);
      if (axial * axial >= least)
        continue;
      const glm::dvec3 radial = off - axial * one.axis;
      const double r = glm::length(radial);
      const double squared = axial * axial + (r - arc.radius) * (r - arc.radius);
      if (squared >= least)
        continue;
      const double x = glm::dot(radial, arc.u);
      const double y = glm::dot(radial, arc.v);
      if (!arc.holds(std::atan2(y, x)))
        continue;
      least = squared;
      nearest.foot = arc.centre + (r > 1e-12 ? (arc.radius / r) * radial : arc.radius * arc.u);
    }
    nearest.distance = std::sqrt(least);
  }

  const SolventAccessible& m_surface;
  std::vector<std::uint32_t> m_balls;
  std::vector<Arc> m_arcs;
  std::vector<glm::dvec3> m_corners;
  double m_spacing;
  double m_reach = reachOf(m_spacing);
};

class ExcludedSolid : public ImplicitSolid {
 public:
  explicit ExcludedSolid(const SolventAccessible& surface) : m_surface(surface) {}

  std::vector<Box> boxes() const override {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < m_surface.balls().size(); ++i)
      if (m_surface.isExposed(i)) {
        const Ball& ball = m_surface.balls()[i];
        // The surface touches the atom or spans the gap to the next one, within the grown ball.
        const bool alone = m_surface.neighboursOf(i).empty();
        const double radius = alone ? ball.radius - probeRadius : ball.radius;
        boxes.push_back({glm::vec3(ball.centre - radius), glm::vec3(ball.centre + radius)});
      }
    return boxes;
  }

  std::unique_ptr<LocalField> within(const Box& box, double spacing) const override {
    const glm::dvec3 low(box.low);
    const glm::dvec3 high(box.high);
    std::vector<std::uint32_t> balls = m_surface.ballsNear(low, high, reachOf(spacing));
    if (balls.empty())
      return nullptr;
    auto field = std::make_unique<ProbeField>(m_surface, std::move(balls), spacing);
    // The distance changes by at most that between the points, so the middle stands for the box.
    const double half = 0.5 * glm::length(high - low);
    const double depth = field->depth(0.5 * (low + high));
    if (depth > probeRadius + half || (depth < 0.0 && depth + half < probeRadius))
      return nullptr;
    field->addArcs(low, high);
    return field;
  }

 private:
  const SolventAccessible& m_surface;
};

/// Returns the connected pieces of a mesh, as the piece of each triangle.
std::vector<std::uint32_t> piecesOf(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto rootOf = [&](std::uint32_t v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles) {
    parent[rootOf(t[1])] = rootOf(t[0]);
    parent[rootOf(t[2])] = rootOf(t[0]);
  }
  std::vector<std::uint32_t> pieces;
  pieces.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    pieces.push_back(rootOf(t[0]));
  return pieces;
}

/// Holds sums over one piece of the surface.
struct Piece {
  double volume = 0.0;
  Box box;
  std::vector<std::uint32_t> triangles;
};

/// Returns the solid angle under which a triangle is seen from p (van Oosterom & Strackee 1983).
double solidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return 2.0 *
         std::atan2(glm::dot(a, glm::cross(b, c)),
                    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

bool holds(const TriangleMesh& mesh, const Piece& piece, const glm::dvec3& p) {
  const glm::vec3 at(p);
  if (glm::clamp(at, piece.box.low, piece.box.high) != at)
    return false;
  double sum = 0.0;
  for (const std::uint32_t t : piece.triangles) {
    const Triangle& v = mesh.triangles[t];
    sum += solidAngle(glm::dvec3(mesh.positions[v[0]]) - p, glm::dvec3(mesh.positions[v[1]]) - p,
                      glm::dvec3(mesh.positions[v[2]]) - p);
  }
  return std::abs(sum) > 6.0;
}

std::vector<Piece> measured(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> rootOf = piecesOf(mesh);
  std::unordered_map<std::uint32_t, std::size_t> numbers;
  std::vector<Piece> pieces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [entry, isNew] = numbers.try_emplace(rootOf[t], pieces.size());
    if (isNew)
      pieces.emplace_back();
    Piece& piece = pieces[entry->second];
    const Triangle& v = mesh.triangles[t];
    const glm::dvec3 origin(
        mesh.positions[mesh.triangles[piece.triangles.empty() ? t : piece.triangles.front()][0]]);
    piece.volume += glm::dot(glm::dvec3(mesh.positions[v[0]]) - origin,
                             glm::cross(glm::dvec3(mesh.positions[v[1]]) - origin,
                                        glm::dvec3(mesh.positions[v[2]]) - origin));
    for (const std::uint32_t corner : v)
      piece.box.add(mesh.positions[corner]);
    piece.triangles.push_back(t);
  }
  return pieces;
}

/// Leaves out the pieces that bound a void without a guest.
void fillVoids(TriangleMesh& mesh, std::span<const glm::dvec3> guests) {
  std::vector<Triangle> kept;
  for (const Piece& piece : measured(mesh)) {
    // Fewer than four triangles lie flat on each other: they are a speck below the lattice's
    // spacing.
    if (piece.triangles.size() < 4)
      continue;
    if (piece.volume < 0.0 && std::none_of(guests.begin(), guests.end(), [&](const glm::dvec3& p) {
          return holds(mesh, piece, p);
        }))
      continue;
    for (const std::uint32_t t : piece.triangles)
      kept.push_back(mesh.triangles[t]);
  }
  std::vector<std::uint32_t> number(mesh.positions.size(), 0xffffffffu);
  TriangleMesh result;
  for (Triangle t : kept) {
    for (std::uint32_t& v : t) {
      if (number[v] == 0xffffffffu) {
        number[v] = std::uint32_t(result.positions.size());
        result.positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
    result.triangles.push_back(t);
  }
  mesh = std::move(result);
}

}  // namespace

TriangleMesh excludedSurface(const SolventAccessible& accessible,
                             std::span<const glm::dvec3> guests, double spacing,
                             const std::function<bool()>& goesOn) {
  TriangleMesh mesh = latticeMesh(ExcludedSolid(accessible), spacing, goesOn);
  fillVoids(mesh, guests);
  return mesh;
}

}  // namespace sline::model
