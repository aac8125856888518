// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
// The cosine of the sharpest turn from one step to the next.
constexpr float sharpestTurn = 0.8f;
// The most triangles that one call may cross; a fan of slivers must not hold a picture up.
constexpr int mostCrossings = 400;
}  // namespace

bool SurfaceWalk::start(bool along) {
  m_direction = glm::vec3(0.0f);
  if (!aim())
    return false;
  if (!along)
    m_direction = -m_direction;
  return true;
}

/// Points the direction along the field where the walk stands, without turning back.
bool SurfaceWalk::aim() {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  const auto p = m_surface.mesh->positions();
  const glm::vec3 normal = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  const float area2 = glm::dot(normal, normal);
  if (!(area2 > 0.0f))
    return false;
  const bool underWay = m_direction != glm::vec3(0.0f);
  const glm::vec3 ahead = underWay ? m_direction : m_directions[t[0]];
  glm::vec3 along(0.0f);
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 d = m_directions[t[std::size_t(i)]];
    along += (glm::dot(d, ahead) < 0.0f ? -m_at.barycentric[i] : m_at.barycentric[i]) * d;
  }
  along -= glm::dot(along, normal) / area2 * normal;
  const float length = glm::length(along);
  if (!(length > 1e-6f))
    return false;
  along /= length;
  if (underWay && glm::dot(along, m_direction) < sharpestTurn)
    return false;
  m_direction = along;
  return true;
}

bool SurfaceWalk::cross(int corner) {
  const std::uint32_t next = m_neighbours.across(m_at.triangle, corner);
  if (next == model::FaceNeighbours::none)
    return false;
  const model::Triangle& from = m_surface.mesh->triangles()[m_at.triangle];
  const model::Triangle& to = m_surface.mesh->triangles()[next];
  glm::vec3 at(0.0f);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != corner && from[std::size_t(i)] == to[std::size_t(j)])
        at[j] = m_at.barycentric[i];
  const float sum = at.x + at.y + at.z;
  if (!(sum > 0.0f))
    return false;
  m_at = {next, at / sum};
  return true;
}

bool SurfaceWalk::advance(float distance) {
  for (int crossings = 0; crossings < mostCrossings; ++crossings) {
    if (!aim())
      return false;
    const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
    const auto p = m_surface.mesh->positions();
    const glm::vec3 e1 = p[t[1]] - p[t[0]];
    const glm::vec3 e2 = p[t[2]] - p[t[0]];
    const glm::vec3 normal = glm::cross(e1, e2);
    const float area2 = glm::dot(normal, normal);
    // Barycentric coordinates per millimetre along the direction.
    const float r1 = glm::dot(glm::cross(m_direction, e2), normal) / area2;
    const float r2 = glm::dot(glm::cross(e1, m_direction), normal) / area2;
    const glm::vec3 rate(-r1 - r2, r1, r2);
    float step = distance;
    int corner = -1;
    for (int i = 0; i < 3; ++i)
      if (rate[i] < 0.0f && -m_at.barycentric[i] / rate[i] < step) {
        step = std::max(-m_at.barycentric[i] / rate[i], 0.0f);
        corner = i;
      }
    m_at.barycentric = glm::clamp(m_at.barycentric + step * rate, glm::vec3(0.0f), glm::vec3(1.0f));
    distance -= step;
    if (corner < 0)
      return true;
    m_at.barycentric[corner] = 0.0f;
    if (!cross(corner))
      return false;
  }
  return false;
}

}  // namespace sline::render
