// SPDX-License-Identifier: Apache-2.0
// Intersects rays with surfaces that planes cut: which part of the ray is kept, and what it meets
// first.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "model/geometry/bvh.h"
#include "model/geometry/plane.h"

namespace sline::model {

/// Holds the part of a ray that planes keep, in multiples of its direction.
struct KeptSpan {
  double nearest = 0.0;
  double farthest = std::numeric_limits<double>::infinity();
  /// The indices of the planes at which the part ends; absent at an end of the ray itself.
  std::optional<std::size_t> entered;
  std::optional<std::size_t> left;

  bool empty() const { return !(nearest <= farthest); }
};

/// Returns the part of the ray that all planes together keep.
KeptSpan keptSpan(const Ray& ray, std::span<const Plane> planes);

/// Returns the ray between the ends of keptSpan; `nearest` is beyond `farthest` where nothing is
/// left.
Ray keptPart(const Ray& ray, std::span<const Plane> planes);

/// Tells whether the ray meets the box, and says yes in doubt; an object whose box is missed needs
/// no tree.
bool reaches(const Ray& ray, const Box& box);

/// Holds the place where a ray meets what planes leave of a surface.
struct CutHit {
  Hit hit;
  bool cutFace = false;  ///< a cut face, which has no triangles: `hit.t` is where it is entered
};

/// Returns the nearest place on the part of the ray that the planes keep. A ray that enters at a
/// plane and sees the surface from within came through the face of the cut.
std::optional<CutHit> nearestKept(const Bvh& tree, const Ray& ray, std::span<const Plane> planes);

}  // namespace sline::model
