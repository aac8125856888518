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

}  // namespace sline::model
