// SPDX-License-Identifier: Apache-2.0
// Reading what a sub-command works on: the same flags and the same messages everywhere.
#pragma once

#include <string>
#include <vector>

#include "app/cli/files/progress.h"
#include "model/base/result.h"
#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

/// As typed; empty texts leave the importer's own choice.
struct InputFlags {
  std::vector<std::string> inputs;
  std::string frame;
  std::string smooth;
  std::string unit;
  double decimateMm = 0;  ///< 0: not at all
  std::string overlay;
  std::string assembly;
  std::vector<std::string> thresholds;
  bool keepScans = false;
  bool verbose = false;  ///< tell of each surface that was repaired
};

/// The importer's options; an error is a wrong use.
Result<model::ImportOptions> importOptions(const InputFlags& flags);

/// Imports with progress on a terminal and passes each warning and note on to standard error.
Result<model::Imported> readInputs(const InputFlags& flags, const model::ImportOptions& options,
                                   Progress& progress);

/// A scene file to be looked at or changed; what it warns of is passed on likewise.
Result<model::SceneDocument> openedScene(const std::string& file);

}  // namespace sline::cli
