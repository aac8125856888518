// SPDX-License-Identifier: Apache-2.0
// Settles how long the unit of a scene's files is.
#pragma once

#include "model/edit/edited.h"

namespace sline::model {

/// Tells whether the unit of any structure is doubted (isUnitDoubted).
bool hasDoubtedUnits(const Scene& scene);

/// Says that all structures are as large as they are: no unit is doubted any more.
Edited withUnitsSettled(const Scene& scene);

}  // namespace sline::model
