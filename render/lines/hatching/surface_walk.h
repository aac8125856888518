// SPDX-License-Identifier: Apache-2.0
// Walks over a triangle mesh along the directions of strokes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "model/geometry/face_neighbours.h"
#include "model/geometry/surface.h"
#include "render/lines/hatching/stroke_directions.h"

namespace sline::render {

/// A place on a mesh.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  glm::vec3 barycentric{0.0f};
};

/// Interpolates values given at a mesh's vertices at a place on the mesh.
template <class Values>
auto valueAt(const model::Mesh& mesh, const Values& values, const SurfacePoint& at) {
  const model::Triangle& t = mesh.triangles()[at.triangle];
  return at.barycentric.x * values[t[0]] + at.barycentric.y * values[t[1]] +
         at.barycentric.z * values[t[2]];
}

/// A walk keeps its course wherever the field's sign would turn it around.
class SurfaceWalk {
 public:
  SurfaceWalk(const model::Surface& surface, const model::FaceNeighbours& neighbours,
              const StrokeDirections& directions, const SurfacePoint& start)
      : m_surface(surface), m_neighbours(neighbours), m_directions(directions), m_at(start) {}

  /// Sets out along the field's direction, or against it.
  bool start(bool along);
  /// Goes `distance` mm; returns false, at the last place reached, where the mesh ends or the field
  /// turns sharply.
  bool advance(float distance);

  const SurfacePoint& at() const { return m_at; }
  glm::vec3 position() const { return valueAt(*m_surface.mesh, m_surface.mesh->positions(), m_at); }

 private:
  bool aim();
  bool cross(int corner);

  const model::Surface& m_surface;
  const model::FaceNeighbours& m_neighbours;
  const StrokeDirections& m_directions;
  SurfacePoint m_at;
  glm::vec3 m_direction{0.0f};
};

}  // namespace sline::render
