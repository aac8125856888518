// SPDX-License-Identifier: Apache-2.0
// Makes a closed triangle mesh of a solid given by a function: marching tetrahedra on the
// body-centred cubic lattice, in which the tetrahedra are all alike and nearly regular, so that it
// leaves no stripes on the surface. Lattice points close to the surface are moved onto it (Labelle
// & Shewchuk, "Isosurface Stuffing", SIGGRAPH 2007), which is what keeps slivers away.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

struct FieldPoint {
  double value = 0.0;  ///< positive inside; grows by at most one per unit of length
  glm::dvec3 onSurface{0.0, 0.0, 0.0};  ///< near the surface: the point of it nearest to this one
};

/// Represents the function within one box. Its answer depends on the point alone, not on the box.
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
  /// Returns boxes that together hold the surface.
  virtual std::vector<Box> boxes() const = 0;
  /// Returns the function within a box, or null where the box certainly holds no surface. Values
  /// need be true only up to `spacing` from it; farther away their sign is enough.
  virtual std::unique_ptr<LocalField> within(const Box& box, double spacing) const = 0;
};

struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Returns a closed, manifold mesh that is oriented outward, with edges of about 0.7 spacings and 6
/// triangles per squared spacing of surface. Coordinates stay within 500,000 spacings of the
/// origin. The mesh is empty where `goesOn` says no.
TriangleMesh latticeMesh(const ImplicitSolid& solid, double spacing,
                         const std::function<bool()>& goesOn);

}  // namespace sline::model
