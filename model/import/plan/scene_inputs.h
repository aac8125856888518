// SPDX-License-Identifier: Apache-2.0
// Scene files among the inputs: opened as they are and put together with the rest.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include "model/import/plan/import.h"

namespace sline::model {

/// Reads the scene files and puts them below each other; the error is of the first that cannot be
/// read. Warns of options that do not apply to them.
Result<Imported> openScenes(std::span<const std::filesystem::path> files,
                            const ImportOptions& options);

/// Tells of options that do not apply to scene files.
void warnOfOptions(const ImportOptions& options, std::vector<ImportWarning>& warnings);

/// Which id a node of what was added has now.
using NewIds = std::map<NodeId, NodeId>;

/// Adds scans, and nodes, sections, annotations and views under ids that are free in `to`; its own
/// keep theirs. Its key light goes before the other's.
NewIds append(Scene& to, const Scene& added);
/// The same with reports and further files.
NewIds append(Imported& to, Imported added);

}  // namespace sline::model
