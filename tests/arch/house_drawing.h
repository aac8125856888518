// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/arch/house.h"

namespace sline::arch {

/// Returns the rooms as an SVG drawing: layers above each other, in each the rooms above those that
/// they include, and an arrow wherever no way round says the same. Rooms of cli, demo, import,
/// export and passes are one box each; rooms that may include whole layers have no arrows.
std::string drawingOf(const House& house);

}  // namespace sline::arch
