// SPDX-License-Identifier: Apache-2.0
// Derives cameras of panels from those of others.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "model/camera/camera.h"
#include "model/figure/figure.h"
#include "render/labels/seen/shapes.h"

namespace sline::render {

/// Returns the camera without perspective that shows the target in the same size.
model::Camera inParallel(model::Camera camera);

/// Returns the camera of an inset of that size that shows a part of a picture of another size. In
/// perspective it is turned about the same eye, so that it sees the same surfaces.
model::Camera insetCamera(const model::Camera& camera, const glm::vec2& size,
                          const model::FigureBox& part, const glm::vec2& insetSize);

/// Returns the corners, from the upper left one clockwise, of what a camera's picture of that size
/// shows, as they lie in the picture of the other camera, which has the same eye or the same
/// direction.
std::array<glm::vec2, 4> cornersIn(const model::Camera& camera, const glm::vec2& size,
                                   const model::Camera& inset, const glm::vec2& insetSize);

}  // namespace sline::render
