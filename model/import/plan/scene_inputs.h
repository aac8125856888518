// SPDX-License-Identifier: Apache-2.0
// Opens scene files among the inputs as they are and joins them with the rest.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include "model/import/plan/import.h"
#include "model/import/plan/patients.h"

namespace sline::model {

/// Holds scene files in one scene, and what each of them knows of whose it is.
struct OpenedScenes {
  Imported all;
  std::vector<TracedScene> traced;
};

/// Reads the scene files and puts them below each other; the error is that of the first that cannot
/// be read, or says that they are of several patients and the options do not want that. Warns of
/// options that do not apply to them.
Result<OpenedScenes> openScenes(std::span<const std::filesystem::path> files,
                                const ImportOptions& options);

/// Warns of options that do not apply to scene files.
void warnOfOptions(const ImportOptions& options, std::vector<ImportWarning>& warnings);

/// Maps the id that a node had in the added scene to its id now.
using NewIds = std::map<NodeId, NodeId>;

/// Adds scans, traces, and nodes, sections, annotations and views under ids that are free in `to`;
/// the nodes of `to` keep theirs. The key light of `to` takes precedence over the other's.
NewIds append(Scene& to, const Scene& added);
/// Adds reports and further files as well.
NewIds append(Imported& to, Imported added);

}  // namespace sline::model
