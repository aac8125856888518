// SPDX-License-Identifier: Apache-2.0
// Reports what an import would do, for people and for programs.
#pragma once

#include <string>

#include "app/cli/files/json_values.h"
#include "model/import/plan/plan.h"

namespace sline::cli {

/// Returns "inputs", "nodes" (groups and structures in tree order, each structure with its file,
/// its frame and unit and what decided them), "bounds_mm", "left_out" and
/// "unit_doubts".
Json planJson(const model::ImportPlan& plan);

/// Returns the tree, then frames and units with their reasons, then what would be left out or
/// mended.
std::string planText(const model::ImportPlan& plan);

}  // namespace sline::cli
