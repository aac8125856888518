// SPDX-License-Identifier: Apache-2.0
// Computes the view-dependent fields of METHOD §3 at one vertex. v̂ points from the surface to the
// eye everywhere in this code (S and C write the opposite direction).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/camera/camera.h"
#include "model/geometry/clusters.h"

namespace sline::render {

/// Returns the eye of a camera: a position, or for a parallel projection the unit direction towards
/// it.
inline model::EyePoint eyeOf(const model::Camera& camera) {
  if (camera.projection == model::Projection::orthographic)
    return {.value = model::cameraFrame(camera).back, .atInfinity = true};
  return {.value = camera.eye, .atInfinity = false};
}

/// Returns a vector from p towards the eye, of any length.
inline glm::vec3 vectorTo(const model::EyePoint& eye, const glm::vec3& p) {
  return eye.atInfinity ? eye.value : eye.value - p;
}

/// Returns v̂, the unit vector from p towards the eye.
inline glm::vec3 directionTo(const model::EyePoint& eye, const glm::vec3& p) {
  return eye.atInfinity ? eye.value : glm::normalize(eye.value - p);
}

/// Returns ŵ in the principal frame: its components along e1 and e2 = n × e1. It is zero where the
/// surface faces the eye exactly and ŵ has no direction.
inline glm::vec2 viewInPrincipalFrame(const glm::vec3& n, const glm::vec3& e1, const glm::vec3& v) {
  const glm::vec2 w{glm::dot(v, e1), glm::dot(v, glm::cross(n, e1))};
  const float length = glm::length(w);
  return length > 0.0f ? w / length : glm::vec2(0.0f);
}

/// Returns κr = ⟨S ŵ, ŵ⟩, 1/mm.
inline float radialCurvature(const glm::vec2& k, const glm::vec2& w) {
  return k.x * w.x * w.x + k.y * w.y * w.y;
}

/// Returns dᵀ·S·d = κr·|w|²·|d|² for a vector d towards the eye.
inline float bendingTowards(const glm::vec3& n, const glm::vec3& e1, const glm::vec2& k,
                            const glm::vec3& d) {
  const float along = glm::dot(d, e1);
  const float across = glm::dot(d, glm::cross(n, e1));
  return k.x * along * along + k.y * across * across;
}

/// Returns nv of ⟨n, d⟩ and |d|².
inline float cosineOf(float facing, float squaredDistance) {
  return facing / std::sqrt(squaredDistance);
}

/// Returns κr for a vector d towards the eye, 1/mm.
inline float radialCurvatureTowards(const glm::vec3& n, const glm::vec3& e1, const glm::vec2& k,
                                    const glm::vec3& d) {
  const float facing = glm::dot(n, d);
  const float d2 = glm::dot(d, d);
  return bendingTowards(n, e1, k, d) / std::max(d2 - facing * facing, 1e-12f * d2);
}

/// Returns Dκr = C(ŵ,ŵ,ŵ) − 2·τr²·nv/|w| with τr = ⟨S ŵ, n×ŵ⟩ (METHOD §3: exact everywhere, unlike
/// the form in D's appendix), 1/mm².
inline float radialCurvatureDerivative(const glm::vec2& k, const glm::vec4& c, const glm::vec2& w,
                                       float nv) {
  const float cubic = c.x * w.x * w.x * w.x + 3.0f * c.y * w.x * w.x * w.y +
                      3.0f * c.z * w.x * w.y * w.y + c.w * w.y * w.y * w.y;
  const float torsion = (k.y - k.x) * w.x * w.y;
  const float sine = std::sqrt(std::max(0.0f, 1.0f - nv * nv));
  return cubic - 2.0f * torsion * torsion * nv / std::max(sine, 1e-6f);
}

/// Returns k = S w + (nv/d)·w, the gradient over the surface of the headlight's brightness nv;
/// `distance` is d, from the eye, infinite for a parallel projection (METHOD §3), 1/mm.
inline glm::vec3 lightGradient(const glm::vec3& n, const glm::vec3& e1, const glm::vec2& k,
                               const glm::vec3& v, float distance) {
  const glm::vec3 e2 = glm::cross(n, e1);
  const float nv = glm::dot(n, v);
  const glm::vec3 w = v - nv * n;
  const glm::vec3 sw = k.x * glm::dot(w, e1) * e1 + k.y * glm::dot(w, e2) * e2;
  return std::isfinite(distance) ? sw + nv / distance * w : sw;
}

}  // namespace sline::render
