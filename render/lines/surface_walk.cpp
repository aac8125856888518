// SPDX-License-Identifier: Apache-2.0
#include "render/lines/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
// Cosine of the sharpest turn from one step to the next.
constexpr float sharpestTurn = 0.3f;
// Triangles that one call may cross; a fan of slivers must not hold a picture up.
constexpr int mostCrossings = 400;

template <class Value>
Value mixed(const Value& a, const Value& b, const Value& c, const glm::vec3& at) {
  return at.x * a + at.y * b + at.z * c;
}
}  // namespace

glm::vec3 GradientWalk::position() const {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  const auto p = m_surface.mesh->positions();
  return mixed(p[t[0]], p[t[1]], p[t[2]], m_at.barycentric);
}

glm::vec3 GradientWalk::normal() const {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  const std::vector<glm::vec3>& n = m_surface.normals;
  const glm::vec3 sum = mixed(n[t[0]], n[t[1]], n[t[2]], m_at.barycentric);
  return sum / std::max(glm::length(sum), 1e-20f);
}

float GradientWalk::weight() const {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  return mixed(m_fields[t[0]].weight, m_fields[t[1]].weight, m_fields[t[2]].weight,
               m_at.barycentric);
}

float GradientWalk::angle() const {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  return mixed(m_fields[t[0]].angle, m_fields[t[1]].angle, m_fields[t[2]].angle, m_at.barycentric);
}

bool GradientWalk::start(bool along) {
  m_direction = glm::vec3(0.0f);
  if (!aim())
    return false;
  if (!along)
    m_direction = -m_direction;
  return true;
}

/// Points the direction along k where the walk stands, without turning back.
bool GradientWalk::aim() {
  const model::Triangle& t = m_surface.mesh->triangles()[m_at.triangle];
  const auto p = m_surface.mesh->positions();
  const glm::vec3 normal = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  const float area2 = glm::dot(normal, normal);
  if (!(area2 > 0.0f))
    return false;
  glm::vec3 k = mixed(m_fields[t[0]].k, m_fields[t[1]].k, m_fields[t[2]].k, m_at.barycentric);
  k -= glm::dot(k, normal) / area2 * normal;
  const float length = glm::length(k);
  if (!(length > 1e-20f))
    return false;
  k /= length;
  const bool underWay = m_direction != glm::vec3(0.0f);
  const float turn = glm::dot(k, m_direction);
  if (underWay && std::abs(turn) < sharpestTurn)
    return false;
  m_direction = underWay && turn < 0.0f ? -k : k;
  return true;
}

bool GradientWalk::cross(int corner) {
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

bool GradientWalk::advance(float distance) {
  for (int crossings = 0; crossings < mostCrossings; ++crossings) {
    if (!aim() || angle() >= 1.0f)
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
