// SPDX-License-Identifier: Apache-2.0
// Reduces an order to what its page may hold.
#pragma once

#include <glm/vec2.hpp>
#include <set>

#include "render/export/order/export_order.h"
#include "render/export/students/students_options.h"

namespace sline::render {

/// The shape of the picture that a page shows on a desk, millimetres.
inline constexpr glm::vec2 pagePictureMm{160.0f, 90.0f};

/// Returns the order with those structures and annotations alone that are shown as the page opens
/// or in one of its views, without anything that nobody sees: scans, files' names, notes. Where
/// there are no views, what is shown is one; where there are no labels, all has some
/// (`StudentsOptions::foundLabels`).
ExportOrder pageOrder(const ExportOrder& order);

/// Returns the structures of the page that come after those in focus; none where nothing is.
std::set<model::NodeId> laterStructures(const model::Scene& scene);

/// Returns how many triangles the structures have together, each mesh counted once.
std::size_t trianglesOf(const model::Scene& scene);

struct SimplifiedScene {
  model::Scene scene;
  float errorMm = 0.0f;  ///< the farthest that a surface is off, as measured; 0: none is
};

/// Returns the scene with as few triangles as the options ask for; places on surfaces move with
/// them. Where the number that was asked for cannot be reached there are as few as can be.
SimplifiedScene simplifiedScene(const model::Scene& scene, const StudentsOptions& own,
                                const ExportProgress& progress);

}  // namespace sline::render
