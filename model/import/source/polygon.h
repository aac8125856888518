// SPDX-License-Identifier: Apache-2.0
// Cuts a polygon in space into triangles.
#pragma once

#include <cstdint>
#include <span>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Appends the triangles of one loop of three or more valid indices, in the loop's orientation. A
/// loop that is convex seen along its Newell normal becomes a fan from its first corner, another
/// one is cut ear by ear (Meisters 1975, "Polygons have ears"); one of more than 1,024 corners is
/// always a fan, so that time stays bounded.
void cutPolygon(std::span<const std::uint32_t> loop, std::span<const glm::vec3> positions,
                std::vector<Triangle>& triangles);

}  // namespace sline::model
