// SPDX-License-Identifier: Apache-2.0
// Reports repairs without loss in one line, so that warnings are left to matters that the user can
// act on.
#pragma once

#include <span>

#include "model/import/plan/parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

RepairNotes repairNotes(std::span<const Part> parts, const Sources& sources);

}  // namespace sline::model
