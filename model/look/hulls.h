// SPDX-License-Identifier: Apache-2.0
// Finds hulls by their form, where names tell nothing: the skin around a skull.
#pragma once

#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the indices of those meshes inside which most of another one lies. Surfaces may be open,
/// as scans end somewhere: a place is inside where lines along the axes meet the hull on all sides
/// but one. Of several copies none is the hull of another.
std::vector<std::size_t> hullsAmong(const std::vector<MeshPtr>& meshes);

}  // namespace sline::model
