// SPDX-License-Identifier: Apache-2.0
// Measures the look that a scene opens with, and its parts.
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace sline::bench {

/// Chooses the opening look seven times, each with nothing known of the meshes, and returns a line
/// for the whole and for each part that can be asked for alone, with the least milliseconds by the
/// clock and by the processor; then a checksum of what was chosen, so that two builds' can be
/// compared. Without anything visible it says so.
std::string measureOpening(const model::Scene& scene);

}  // namespace sline::bench
