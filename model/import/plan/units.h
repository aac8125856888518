// SPDX-License-Identifier: Apache-2.0
// Decides how long the unit of each file is, and doubts it where what is named would not be as
// large as such structures are.
#pragma once

#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Fixes each part's unit and says why: as chosen by hand, else as the file's format, header or
/// scene says, else millimetres. Where names tell other sizes, the unit stays, is doubted in the
/// parts' provenance and told in the report with the units that would fit; one that was chosen is
/// never doubted. Where no name tells a size, millimetres that were only assumed are doubted in the
/// provenance of what is together smaller or larger than anything of a body. Says which named
/// structures have no extent.
void decideUnits(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                 ImportReport& report);

}  // namespace sline::model
