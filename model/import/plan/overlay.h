// SPDX-License-Identifier: Apache-2.0
// Lays molecules that are imported together over the first of them.
#pragma once

#include <string>
#include <vector>

#include "model/import/plan/parts.h"

namespace sline::model {

/// Moves the surfaces of each further entry so that its backbone lies on the first one's, where
/// everything imported is molecules and chains match; and gives each entry's chains and bonds
/// colours of their own. Returns a report of one line for each further entry.
std::vector<std::string> overlayMolecules(std::vector<Part>& parts, Overlay overlay);

}  // namespace sline::model
