// SPDX-License-Identifier: Apache-2.0
// Decides which way leads to the left and to the back, for all surfaces that came together.
#pragma once

#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/read_inputs.h"

namespace sline::model {

/// Fixes each part's frame and says why and how sure that is: as chosen by hand, else as the file's
/// format, header or scene says, else as it lies over others of the same names (frame_fit.h), by a
/// clear vote of the names (laterality.h), as it fits in with the others, or by a weak vote. The
/// last two are guesses, and so is the front but where names tell it (FrontVote). Warns
/// where names contradict the files, or nothing fits. A part that was skipped has a vote like any
/// other.
void decideFrames(std::vector<Part>& parts, const ReadInputs& read, const ImportOptions& options,
                  ImportReport& report);

}  // namespace sline::model
