// SPDX-License-Identifier: Apache-2.0
// Rays against surfaces that planes cut: what of the ray is kept, what it meets first.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "model/geometry/bvh.h"
#include "model/geometry/plane.h"

namespace sline::model {

/// The part of a ray that planes keep, in multiples of its direction.
struct KeptSpan {
  double nearest = 0.0;
  double farthest = std::numeric_limits<double>::infinity();
  /// The planes it ends at, by their index; absent at an end of the ray itself.
  std::optional<std::size_t> entered;
  std::optional<std::size_t> left;

  bool empty() const { return !(nearest <= farthest); }
};

/// Returns what all planes together keep of the ray.
KeptSpan keptSpan(const Ray& ray, std::span<const Plane> planes);

/// Returns the ray between the ends of keptSpan; `nearest` beyond `farthest` where that is nothing.
Ray keptPart(const Ray& ray, std::span<const Plane> planes);

/// Returns whether the ray meets the box, in doubt yes: what it does not meet needs no tree.
bool reaches(const Ray& ray, const Box& box);

/// Where a ray meets what planes leave of a surface.
struct CutHit {
  Hit hit;
  bool cutFace = false;  ///< a plane's face, which has no triangles: `hit.t` is where it is entered
};

/// Returns the nearest place on the part of the ray that the planes keep. A ray that enters at a
/// plane and sees the surface from within came through the face of the cut.
std::optional<CutHit> nearestKept(const Bvh& tree, const Ray& ray, std::span<const Plane> planes);

}  // namespace sline::model
