// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/principal_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

constexpr std::size_t trianglesPerTask = 4096;

/// What a triangle's tensor, the mean of its corners', says in the triangle's plane.
struct Principal {
  glm::vec3 direction{0.0f};
  float curvature = 0.0f;
};

Principal principalOf(const model::Surface& surface, const model::Triangle& t) {
  const auto p = surface.mesh->positions();
  const glm::vec3 edge = p[t[1]] - p[t[0]];
  const glm::vec3 normal = glm::cross(edge, p[t[2]] - p[t[0]]);
  const float length = glm::length(edge);
  const float area2 = glm::length(normal);
  if (!(length > 0.0f) || !(area2 > 0.0f))
    return {};
  const glm::vec3 x = edge / length;
  const glm::vec3 y = glm::cross(normal / area2, x);
  float xx = 0.0f;
  float xy = 0.0f;
  float yy = 0.0f;
  for (const std::uint32_t vertex : t) {
    const glm::vec3& e1 = surface.curvature.e1[vertex];
    const glm::vec3 e2 = glm::cross(surface.normals[vertex], e1);
    const glm::vec2& k = surface.curvature.k[vertex] / 3.0f;
    for (const auto& [e, kappa] : {std::pair(e1, k.x), std::pair(e2, k.y)}) {
      const float ex = glm::dot(e, x);
      const float ey = glm::dot(e, y);
      xx += kappa * ex * ex;
      xy += kappa * ex * ey;
      yy += kappa * ey * ey;
    }
  }
  // The axis of the signed maximum, or across it if the minimum is larger in magnitude.
  const float mean = 0.5f * (xx + yy);
  const float apart = std::hypot(0.5f * (xx - yy), xy);
  float turn = 0.5f * std::atan2(2.0f * xy, xx - yy);
  if (mean < 0.0f)
    turn += 1.57079633f;
  return {std::cos(turn) * x + std::sin(turn) * y, std::abs(mean) + apart};
}

}  // namespace

PrincipalField::PrincipalField(const model::Surface& surface)
    : m_surface(surface),
      m_directions(surface.mesh->triangleCount()),
      m_curvatures(surface.mesh->triangleCount()) {
  const auto triangles = surface.mesh->triangles();
  parallelFor(triangles.size(), trianglesPerTask, [&](std::size_t i) {
    const model::Triangle& t = triangles[i];
    const Principal own = principalOf(surface, t);
    m_curvatures[i] = own.curvature;
    const bool anyUmbilic =
        std::any_of(t.begin(), t.end(), [this](std::uint32_t vertex) { return isUmbilic(vertex); });
    m_directions[i] = anyUmbilic ? glm::vec3(0.0f) : own.direction;
  });
}

bool PrincipalField::isUmbilic(std::uint32_t vertex) const {
  const glm::vec2& k = m_surface.curvature.k[vertex];
  const float largest = std::max(std::abs(k.x), std::abs(k.y));
  return !(std::abs(k.x - k.y) > umbilicShare * largest) ||
         !(largest * m_surface.filigreeSize > flatCurvature);
}

glm::dvec2 PrincipalField::Frame::components(const glm::dvec3& direction) const {
  const double uu = glm::dot(u, u);
  const double uv = glm::dot(u, v);
  const double vv = glm::dot(v, v);
  const double du = glm::dot(direction, u);
  const double dv = glm::dot(direction, v);
  const double determinant = uu * vv - uv * uv;
  return {(vv * du - uv * dv) / determinant, (uu * dv - uv * du) / determinant};
}

PrincipalField::Frame PrincipalField::frame(std::uint32_t triangle) const {
  const model::Triangle& t = m_surface.mesh->triangles()[triangle];
  const auto p = m_surface.mesh->positions();
  Frame frame;
  frame.origin = glm::dvec3(p[t[0]]);
  frame.u = glm::dvec3(p[t[1]]) - frame.origin;
  frame.v = glm::dvec3(p[t[2]]) - frame.origin;
  const double perimeter =
      glm::length(frame.u) + glm::length(frame.v) + glm::length(frame.u - frame.v);
  if (perimeter > 0.0)
    frame.inradius = glm::length(glm::cross(frame.u, frame.v)) / perimeter;
  return frame;
}

LinearFlow PrincipalField::flow(std::uint32_t triangle, const Frame& frame,
                                const glm::dvec3& reference) const {
  const model::Triangle& t = m_surface.mesh->triangles()[triangle];
  std::array<glm::dvec2, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (isUmbilic(t[i]))
      continue;
    const glm::dvec3 e1(m_surface.curvature.e1[t[i]]);
    const glm::dvec3 e2 = glm::cross(glm::dvec3(m_surface.normals[t[i]]), e1);
    const double along1 = glm::dot(e1, reference);
    const double along2 = glm::dot(e2, reference);
    const glm::dvec3 nearest = std::abs(along1) >= std::abs(along2) ? (along1 < 0.0 ? -e1 : e1)
                                                                    : (along2 < 0.0 ? -e2 : e2);
    const glm::dvec2 flat = frame.components(nearest);
    const double length = glm::length(frame.along(flat));
    values[i] = length > 1e-9 ? flat / length : glm::dvec2(0.0);
  }
  return {values[0], values[1], values[2]};
}

}  // namespace sline::render
