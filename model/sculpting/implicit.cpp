// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/implicit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

namespace sline::model {

float ellipsoid(const glm::vec3& p, const glm::vec3& semiAxes) {
  // This is f/|∇f| of f = |p/a| − 1 in the form that stays finite at the centre.
  const float k0 = glm::length(p / semiAxes);
  const float k1 = glm::length(p / (semiAxes * semiAxes));
  return k1 > 1e-12f ? k0 * (k0 - 1.0f) / k1 : -std::min({semiAxes.x, semiAxes.y, semiAxes.z});
}

float cushion(const glm::vec3& p, const glm::vec3& semiAxes, float fullness) {
  // This is f/|∇f| of f = Σ (1 − a) q² + a q⁴ − 1, q = p / semiAxes: unlike a power between 2 and 4
  // it leaves no flat spots on the axes.
  const glm::vec3 q = p / semiAxes;
  const glm::vec3 squares = q * q;
  const float f = glm::dot(squares, glm::vec3(1.0f - fullness) + fullness * squares) - 1.0f;
  const glm::vec3 gradient =
      q / semiAxes * (glm::vec3(2.0f - 2.0f * fullness) + 4.0f * fullness * squares);
  const float least = std::min({semiAxes.x, semiAxes.y, semiAxes.z});
  return f / std::max(glm::length(gradient), 1.0f / least);
}

namespace {
/// Returns the smaller of both, rounded by a quartic that meets it with continuous curvature.
float smoothMinimum(float a, float b, float radius) {
  const float h = std::max(radius - std::abs(a - b), 0.0f) / radius;
  return std::min(a, b) - h * h * h * (4.0f - h) * radius / 16.0f;
}

}  // namespace

float blendedUnion(float a, float b, float radius) {
  return smoothMinimum(a, b, radius);
}

float blendedDifference(float a, float b, float radius) {
  return -smoothMinimum(-a, b, radius);
}

float distanceToBox(const Box& box, const glm::vec3& p) {
  return glm::length(glm::max(glm::max(box.low - p, p - box.high), glm::vec3(0.0f)));
}

Box grown(Box box, float by) {
  box.low -= by;
  box.high += by;
  return box;
}

Field mirrored(Field field, float plane) {
  return [field = std::move(field), plane](const glm::vec3& p) {
    return field({2.0f * plane - p.x, p.y, p.z});
  };
}

Box mirrored(const Box& box, float plane) {
  return {{2.0f * plane - box.high.x, box.low.y, box.low.z},
          {2.0f * plane - box.low.x, box.high.y, box.high.z}};
}

float wave(const glm::vec3& p, float wavelength, float phase) {
  // These are three plane waves in directions that share no axis, each bent by the one before.
  const float k = 2.0f * std::numbers::pi_v<float> / wavelength;
  const float a = std::sin(k * glm::dot(p, {0.68f, 0.53f, 0.51f}) + phase);
  const float b = std::sin(k * glm::dot(p, {-0.62f, 0.74f, 0.27f}) + 2.1f * phase + 0.8f * a);
  const float c = std::sin(k * glm::dot(p, {0.33f, -0.45f, 0.83f}) + 3.3f * phase + 0.8f * b);
  return (a + b + c) / 3.0f;
}

Blob::Blob(const glm::vec3& centre, const glm::vec3& semiAxes, const glm::vec3& degrees)
    : m_centre(centre), m_semiAxes(semiAxes) {
  const auto turn = [](float angle, const glm::vec3& axis) {
    return glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(angle), axis));
  };
  const glm::mat3 toWorld =
      turn(degrees.z, {0, 0, 1}) * turn(degrees.y, {0, 1, 0}) * turn(degrees.x, {1, 0, 0});
  m_toOwn = glm::transpose(toWorld);
  glm::vec3 half;
  for (int axis = 0; axis < 3; ++axis)
    half[axis] =
        glm::length(glm::vec3(toWorld[0][axis], toWorld[1][axis], toWorld[2][axis]) * semiAxes);
  m_bounds = {centre - half, centre + half};
}

float Blob::distance(const glm::vec3& p) const {
  return ellipsoid(m_toOwn * (p - m_centre), m_semiAxes);
}

}  // namespace sline::model
