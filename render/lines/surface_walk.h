// SPDX-License-Identifier: Apache-2.0
// Walks over a triangle mesh along a direction field given at its vertices.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "model/geometry/face_neighbours.h"
#include "model/geometry/surface.h"
#include "render/lines/hatch_tone.h"

namespace sline::render {

/// A place on a mesh.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  glm::vec3 barycentric{0.0f};
};

/// One walk along the light gradient k: it follows the field whichever way that points, as long as
/// it turns no corner.
class GradientWalk {
 public:
  GradientWalk(const model::Surface& surface, const model::FaceNeighbours& neighbours,
               const HatchFields& fields, const SurfacePoint& start)
      : m_surface(surface), m_neighbours(neighbours), m_fields(fields), m_at(start) {}

  /// Sets out along k, or against it.
  bool start(bool along);
  /// Goes `distance` mm; false, at the last place reached, where the mesh or the field ends, the
  /// field turns sharply or the surface turns away from the eye.
  bool advance(float distance);

  glm::vec3 position() const;
  glm::vec3 normal() const;  ///< unit, as the mesh has it
  float weight() const;
  float angle() const;
  const glm::vec3& direction() const { return m_direction; }  ///< unit, in the triangle's plane

 private:
  bool aim();
  bool cross(int corner);

  const model::Surface& m_surface;
  const model::FaceNeighbours& m_neighbours;
  const HatchFields& m_fields;
  SurfacePoint m_at;
  glm::vec3 m_direction{0.0f};
};

}  // namespace sline::render
