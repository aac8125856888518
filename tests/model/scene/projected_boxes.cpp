// SPDX-License-Identifier: Apache-2.0
#include "tests/model/scene/projected_boxes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

using namespace sline::model;

namespace sline::test {

Box boxOf(const glm::vec3& low, const glm::vec3& high) {
  Box box;
  box.add(low);
  box.add(high);
  return box;
}

std::vector<glm::vec3> corners(const Box& box) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) != 0 ? box.high.x : box.low.x,
                        (i & 2) != 0 ? box.high.y : box.low.y,
                        (i & 4) != 0 ? box.high.z : box.low.z);
  return points;
}

glm::vec3 project(const Camera& camera, const Box& bounds, float aspect, const glm::vec3& p) {
  const glm::vec4 clip =
      projectionMatrix(camera, bounds, aspect) * viewMatrix(camera) * glm::vec4(p, 1.0f);
  return glm::vec3(clip) / clip.w;
}

bool close(float a, float b, float tolerance) {
  return std::abs(a - b) <= tolerance;
}

bool close(const glm::vec3& a, const glm::vec3& b, float tolerance) {
  return glm::distance(a, b) <= tolerance;
}

}  // namespace sline::test
