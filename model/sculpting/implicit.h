// SPDX-License-Identifier: Apache-2.0
// Defines shapes as signed distances: negative inside, positive outside, in millimetres (near the
// surface; far away only the sign is exact). Anatomy is built by blending a few of them.
#pragma once

#include <array>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

using Field = std::function<float(const glm::vec3&)>;

/// Returns about the signed distance to an ellipsoid at the origin, exact to first order at its
/// surface.
float ellipsoid(const glm::vec3& p, const glm::vec3& semiAxes);

/// Returns about the signed distance to a body between an ellipsoid (`fullness` 0) and a box,
/// smooth everywhere for `fullness` up to about 0.5.
float cushion(const glm::vec3& p, const glm::vec3& semiAxes, float fullness);

/// Returns the union (difference, intersection) of two shapes; the seam is rounded over about
/// `radius` mm, with continuous curvature.
float blendedUnion(float a, float b, float radius);
float blendedDifference(float a, float b, float radius);
inline float blendedIntersection(float a, float b, float radius) {
  return -blendedUnion(-a, -b, radius);
}
/// Tells whether the boxes share an inner point.
inline bool meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
}

/// Returns how far the point lies outside the box; 0 inside.
float distanceToBox(const Box& box, const glm::vec3& p);
/// Returns the box with its faces moved outward by that much.
Box grown(Box box, float by);
/// Returns the shape reflected in the plane x = `plane`.
Field mirrored(Field field, float plane);
Box mirrored(const Box& box, float plane);
/// Returns a slow wave through space between −1 and 1 without a visible lattice, which gives a
/// surface liveliness or lobes. `wavelength` is the mean distance between crests, in mm.
float wave(const glm::vec3& p, float wavelength, float phase);

/// An ellipsoid anywhere in space; its axes are turned by degrees about x, then y, then z.
class Blob {
 public:
  Blob(const glm::vec3& centre, const glm::vec3& semiAxes, const glm::vec3& degrees = {0, 0, 0});
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }

 private:
  glm::vec3 m_centre;
  glm::vec3 m_semiAxes;
  glm::mat3 m_toOwn;
  Box m_bounds;
};

/// Holds a place on a vessel's centre line.
struct TubePoint {
  glm::vec3 position;
  float radius;
};

/// Holds a place on the middle line of a flat shape: half its width along `across`, half its
/// thickness at right angles to that and to the line. `across` need be neither unit nor at right
/// angles to the line; where it changes from place to place the band twists.
struct BandPoint {
  glm::vec3 position;
  float halfWidth;
  float halfThickness;
  glm::vec3 across;
};

/// A smooth curve through given points (a centripetal cubic spline, of continuous curvature) that
/// carries a few numbers along, with a fast search for its nearest place.
class Curve {
 public:
  struct Knot {
    glm::vec4 main;              ///< position and radius (or half a width)
    glm::vec4 more{0, 0, 0, 0};  ///< a direction and half a thickness
  };
  struct Place {
    glm::vec4 main;
    glm::vec4 more;
    glm::vec3 tangent;  ///< unit vector
  };
  Curve(std::span<const Knot> through, float step);
  /// Returns the place where distance − `weight` · radius is least; beyond the ends it is the end
  /// itself.
  Place nearest(const glm::vec3& p, float weight) const;
  /// Returns the place at `s` knots from the start, 0 to knots − 1.
  Place at(float s) const;
  const std::vector<Knot>& knots() const { return m_knots; }

 private:
  struct Chunk {
    glm::vec3 centre;
    float reach;  ///< includes its segments and their radii
    std::size_t first;
    std::size_t end;
  };
  struct Nearest {
    std::size_t segment = 0;
    float t = 0.0f;
    float distance = std::numeric_limits<float>::infinity();
  };
  void search(const Chunk& chunk, const glm::vec3& p, float weight, Nearest& best) const;
  std::size_t pieceAt(float s) const;
  Knot mixed(std::size_t piece, const std::array<float, 4>& weights) const;
  std::vector<Knot> m_knots;
  std::vector<Knot> m_spline;  ///< the knots and one more at either end
  std::vector<Chunk> m_chunks;
};

/// A tube has a round cross-section along a smooth curve through the given points; its radius
/// changes smoothly between them, and its ends are rounded.
class Tube {
 public:
  explicit Tube(std::span<const TubePoint> through, float step = 2.5f);
  Tube(std::initializer_list<TubePoint> through)
      : Tube(std::span<const TubePoint>(through.begin(), through.size())) {}
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }
  const Curve& course() const { return m_curve; }

 private:
  Curve m_curve;
  Box m_bounds;
};

/// A band is a tube with an elliptic cross-section: a muscle, a nerve, a flattened vein.
class Band {
 public:
  explicit Band(std::span<const BandPoint> through, float step = 3.0f);
  Band(std::initializer_list<BandPoint> through)
      : Band(std::span<const BandPoint>(through.begin(), through.size())) {}
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }

 private:
  Curve m_curve;
  Box m_bounds;
};

/// Returns the distance to all parts, blended where they meet; parts too far away to matter are
/// skipped.
template <class Part>
float blended(std::span<const Part> parts, const glm::vec3& p, float radius) {
  float d = std::numeric_limits<float>::infinity();
  for (const Part& part : parts)
    if (distanceToBox(part.bounds(), p) < d + radius)
      d = blendedUnion(d, part.distance(p), radius);
  return d;
}

template <class Part>
Box boundsOf(std::span<const Part> parts) {
  Box box;
  for (const Part& part : parts)
    box.add(part.bounds());
  return box;
}

}  // namespace sline::model
