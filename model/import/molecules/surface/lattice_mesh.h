// SPDX-License-Identifier: Apache-2.0
// A solid given by a function, as a closed triangle mesh: marching tetrahedra on the body-centred
// cubic lattice, whose tetrahedra are all alike and nearly regular, so that the lattice leaves no
// stripes on the surface. Lattice points close to the surface are moved onto it (Labelle &
// Shewchuk, "Isosurface Stuffing", SIGGRAPH 2007), which is what keeps slivers away.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

struct FieldPoint {
  double value = 0.0;  ///< positive inside; grows by at most one per unit of length
  glm::dvec3 onSurface{0.0, 0.0, 0.0};  ///< near the surface: the surface's point next to this one
};

/// The function within one box. Its answer depends on the point alone, not on the box.
class LocalField {
 public:
  LocalField() = default;
  LocalField(const LocalField&) = delete;
  LocalField& operator=(const LocalField&) = delete;
  virtual ~LocalField() = default;
  virtual FieldPoint at(const glm::dvec3& p) const = 0;
};

class ImplicitSolid {
 public:
  ImplicitSolid() = default;
  ImplicitSolid(const ImplicitSolid&) = delete;
  ImplicitSolid& operator=(const ImplicitSolid&) = delete;
  virtual ~ImplicitSolid() = default;
  /// Boxes that together hold the surface.
  virtual std::vector<Box> boxes() const = 0;
  /// Null where the box certainly holds no surface. Values need be true only up to `spacing` from
  /// it; farther away their sign is enough.
  virtual std::unique_ptr<LocalField> within(const Box& box, double spacing) const = 0;
};

struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Closed, manifold and outward, with edges of about 0.7 spacings; 6 triangles per squared spacing
/// of surface. Coordinates stay within 500,000 spacings of the origin. Empty where `goesOn` says
/// no.
TriangleMesh latticeMesh(const ImplicitSolid& solid, double spacing,
                         const std::function<bool()>& goesOn);

}  // namespace sline::model
