// SPDX-License-Identifier: Apache-2.0
// How the coordinates of surfaces are read, decided for all that came together.
#pragma once

#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Fixes each part's frame and says why: what was chosen by hand, else what the file's format,
/// header or scene says, else the vote of the names (laterality.h). Warns where names contradict
/// what files say. A part that was skipped has a vote like any other.
void decideFrames(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                  ImportReport& report);

/// Fixes each part's unit. Files without a unit of their own are taken as millimetres, but a body
/// part smaller than 3 mm is one in metres.
void decideUnits(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                 ImportReport& report);

}  // namespace sline::model
