// SPDX-License-Identifier: Apache-2.0
// Computes how the headlight's brightness f = ⟨n, v̂⟩ changes over a surface, exactly, for parallel
// and perspective views. Lines that are defined by f's derivatives start from here.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "model/geometry/surface.h"
#include "render/lines/ground/view_fields.h"

namespace sline::render {

/// Derivatives of f at a vertex in the principal frame (e1, e2 = n × e1), 1/mm and 1/mm².
struct Headlight {
  float nv = 0.0f;           ///< f itself
  glm::vec2 w{0.0f};         ///< v̂ − nv·n
  glm::vec2 gradient{0.0f};  ///< ∇f = S·w + (nv/D)·w
  glm::vec3 hessian{0.0f};   ///< f11, f12, f22

  float laplacian() const { return hessian.x + hessian.z; }
  /// Returns the second derivative along a vector, times its length squared.
  float along(const glm::vec2& x) const {
    return x.x * x.x * hessian.x + 2.0f * x.x * x.y * hessian.y + x.y * x.y * hessian.z;
  }
};

/// Returns f's derivatives from the principal curvatures, their derivative C (see
/// model::Curvature), the tangential part w of v̂ and the distance D of the eye, infinite in a
/// parallel projection. With ∂v̂ = −(x − ⟨x,v̂⟩v̂)/D and dn = S the Hessian is
/// C(x,y,w) − nv·⟨Sx,Sy⟩ + [⟨x,w⟩⟨Sw,y⟩ + ⟨Sw,x⟩⟨w,y⟩ − (1 + nv²)⟨Sx,y⟩]/D
/// + nv·[3⟨x,w⟩⟨w,y⟩ − ⟨x,y⟩]/D².
inline Headlight headlight(const glm::vec2& k, const glm::vec4& c, const glm::vec2& w, float nv,
                           float distance) {
  const float near = std::isfinite(distance) ? 1.0f / distance : 0.0f;
  const glm::vec2 sw = k * w;
  const float wide = 3.0f * nv * near * near;
  const float bent = near * (1.0f + nv * nv);
  const float flat = nv * near * near;
  return {.nv = nv,
          .w = w,
          .gradient = sw + nv * near * w,
          .hessian = {c.x * w.x + c.y * w.y - nv * k.x * k.x + 2.0f * near * w.x * sw.x -
                          bent * k.x + wide * w.x * w.x - flat,
                      c.y * w.x + c.z * w.y + near * (w.x * sw.y + sw.x * w.y) + wide * w.x * w.y,
                      c.z * w.x + c.w * w.y - nv * k.y * k.y + 2.0f * near * w.y * sw.y -
                          bent * k.y + wide * w.y * w.y - flat}};
}

/// Returns f's derivatives at a vertex of a surface.
inline Headlight headlightAt(const model::Surface& surface, std::uint32_t vertex,
                             const model::EyePoint& eye) {
  const glm::vec3& p = surface.mesh->positions()[vertex];
  const glm::vec3& n = surface.normals[vertex];
  const glm::vec3& e1 = surface.curvature.e1[vertex];
  const glm::vec3 v = directionTo(eye, p);
  const float distance =
      eye.atInfinity ? std::numeric_limits<float>::infinity() : glm::distance(eye.value, p);
  return headlight(surface.curvature.k[vertex], surface.curvature.derivative[vertex],
                   {glm::dot(v, e1), glm::dot(v, glm::cross(n, e1))}, glm::dot(n, v), distance);
}

/// Returns a vector of the principal frame in space.
inline glm::vec3 inSpace(const model::Surface& surface, std::uint32_t vertex, const glm::vec2& x) {
  const glm::vec3& e1 = surface.curvature.e1[vertex];
  return x.x * e1 + x.y * glm::cross(surface.normals[vertex], e1);
}

}  // namespace sline::render
