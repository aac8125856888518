// SPDX-License-Identifier: Apache-2.0
// What an import would do, before it is done.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "model/import/import.h"

namespace sline::model {

/// A value that can be shown, changed and carried out: the tree with each structure's frame and
/// unit and what decided them (Provenance), surfaces as repaired but not yet smoothed or
/// decimated, and in the
/// report what would be left out and why. Who changes `options` or `inputs` plans again to see the
/// rest.
struct ImportPlan {
  std::vector<std::filesystem::path> inputs;
  ImportOptions options;
  Scene scene;
  ImportReport report;
};

/// Reads everything; the error is that of importInputs.
Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress = {});

/// Imports as planned.
Result<Imported> carriedOut(const ImportPlan& plan, const ImportProgress& progress = {});

}  // namespace sline::model
