// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unordered_map>

#include "model/anatomy/tissue.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Holds what each structure and group is made of, by the id's value.
using Tissues = std::unordered_map<std::uint64_t, Tissue>;

/// Says what the nodes are made of: by their own names (resources/anatomy; sides, numbers and
/// catalogue ids aside), else as the group above them, else unknown.
Tissues tissuesOf(const Scene& scene);

/// Tells whether the structure may be a vessel, nerve or duct, as far as names say: its own, else
/// that of a group above it. Of organs those may that are hollow.
bool mayBeDuct(const Scene& scene, const Node& node, Tissue tissue);

}  // namespace sline::model
