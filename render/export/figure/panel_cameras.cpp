// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/panel_cameras.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/camera/camera_moves.h"
#include "render/labels/seen/screen.h"

namespace sline::render {

model::Camera inParallel(model::Camera camera) {
  if (camera.projection == model::Projection::perspective)
    camera.heightMm = 2.0f * model::edgeSlope(camera) * glm::distance(camera.eye, camera.target);
  camera.projection = model::Projection::orthographic;
  return camera;
}

model::Camera insetCamera(const model::Camera& camera, const glm::vec2& size,
                          const model::FigureBox& part, const glm::vec2& insetSize) {
  const glm::vec2 middle = part.at + 0.5f * part.size;
  const model::Ray sight = Screen(camera, size).sight(middle);
  model::Camera inset = camera;
  // The part lies wholly in the inset, whose shape may be another one.
  float times = std::max(part.size.y, part.size.x * insetSize.y / insetSize.x) / size.y;
  if (camera.projection == model::Projection::orthographic) {
    const glm::vec3 aside = sight.origin - camera.eye;
    inset.eye += aside;
    inset.target += aside;
  } else {
    const glm::vec3 ahead = glm::normalize(camera.target - camera.eye);
    inset.target = camera.eye + glm::distance(camera.eye, camera.target) * sight.direction;
    // Seen aslant, the plane of the picture is farther away and turned.
    times *= glm::dot(ahead, sight.direction);
  }
  return model::withHeight(inset, times);
}

std::array<glm::vec2, 4> cornersIn(const model::Camera& camera, const glm::vec2& size,
                                   const model::Camera& inset, const glm::vec2& insetSize) {
  const Screen whole(camera, size);
  const Screen part(inset, insetSize);
  const float far = glm::distance(inset.eye, inset.target);
  const std::array<glm::vec2, 4> corners{
      glm::vec2(0.0f), {insetSize.x, 0.0f}, insetSize, {0.0f, insetSize.y}};
  std::array<glm::vec2, 4> places{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const model::Ray sight = part.sight(corners[i]);
    places[i] = whole.place(sight.origin + far * sight.direction).value_or(0.5f * size);
  }
  return places;
}

}  // namespace sline::render
