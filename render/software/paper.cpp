// SPDX-License-Identifier: Apache-2.0
#include "render/software/paper.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sline::render {

namespace {

float grainAt(const glm::vec2& point) {
  glm::vec3 p =
      glm::fract(glm::vec3(point.x, point.y, point.x) * glm::vec3(0.1031f, 0.1030f, 0.0973f));
  p += glm::dot(p, glm::vec3(p.y, p.z, p.x) + 33.33f);
  return glm::fract((p.x + p.y) * p.z);
}

float paper(const glm::vec2& pixel) {
  const glm::vec2 cell = glm::floor(pixel);
  glm::vec2 t = pixel - cell;
  t = t * t * (3.0f - 2.0f * t);
  const auto at = [&](float x, float y) { return grainAt(cell + glm::vec2(x, y)); };
  return glm::mix(glm::mix(at(0.0f, 0.0f), at(1.0f, 0.0f), t.x),
                  glm::mix(at(0.0f, 1.0f), at(1.0f, 1.0f), t.x), t.y);
}

}  // namespace

float paperAt(const glm::vec2& pixel, const glm::vec2& grain) {
  const float height =
      0.65f * paper(pixel / grain.y) + 0.35f * paper(0.37f * pixel / grain.y + 17.0f);
  return glm::mix(1.0f, 0.25f + 0.85f * glm::smoothstep(0.25f, 0.6f, height), grain.x);
}

}  // namespace sline::render
