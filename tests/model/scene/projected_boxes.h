// SPDX-License-Identifier: Apache-2.0
// Projects boxes and points with a camera.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "model/camera/camera.h"

namespace sline::test {

model::Box boxOf(const glm::vec3& low, const glm::vec3& high);

std::vector<glm::vec3> corners(const model::Box& box);

/// Returns normalised device coordinates, −1 … 1.
glm::vec3 project(const model::Camera& camera, const model::Box& bounds, float aspect,
                  const glm::vec3& p);

bool close(float a, float b, float tolerance);

bool close(const glm::vec3& a, const glm::vec3& b, float tolerance);

}  // namespace sline::test
