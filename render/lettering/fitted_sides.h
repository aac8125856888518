// SPDX-License-Identifier: Apache-2.0
// Computes the room at a picture's sides before a camera is fitted to what is left of it; the same
// in a window and on a page.
#pragma once

#include <glm/vec2.hpp>

#include "model/camera/free_sides.h"
#include "model/scene/scene.h"
#include "render/lettering/label_style.h"

namespace sline::render {

/// At least this share of the width and of the height is left to the anatomy.
inline constexpr float leastAnatomyShare = 0.3f;

/// Says what stands at the edges besides labels, in millimetres of the output.
struct RoomOfMarks {
  glm::vec2 size{0.0f};  ///< of the width and of the height, opposite sides together
  float legend = 0.0f;   ///< of the width, at the right
  float foot = 0.0f;     ///< of the height, below what `size` has there
};

/// Returns the share of the width and of the height that marks alone leave to the anatomy, 0 … 1.
glm::vec2 shareBesideMarks(const RoomOfMarks& marks, const glm::vec2& size);

/// Returns how much labels and marks take at each side of an output of that size, for a camera that
/// is yet to be fitted: only its direction counts. Each column is as wide as its contents, and
/// lines are broken so that the anatomy between the columns is as large as possible. A side
/// without a column keeps what it has without labels.
model::FreeSides sidesBesideLabels(const model::Scene& scene, const model::Camera& camera,
                                   const glm::vec2& size, const LabelStyle& style,
                                   const RoomOfMarks& marks = {});

}  // namespace sline::render
