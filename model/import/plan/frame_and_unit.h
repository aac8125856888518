// SPDX-License-Identifier: Apache-2.0
// Decides how the coordinates of surfaces are read, for all that came together.
#pragma once

#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Fixes each part's frame and says why: as chosen by hand, else as the file's format, header or
/// scene says, else by the vote of the names (laterality.h). Warns where names contradict the
/// files. A part that was skipped has a vote like any other.
void decideFrames(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                  ImportReport& report);

}  // namespace sline::model
