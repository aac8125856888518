// SPDX-License-Identifier: Apache-2.0
// Reads what a sub-command works on, with the same flags and the same messages everywhere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/files/progress.h"
#include "model/base/result.h"
#include "model/edit/sides.h"
#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

/// Holds the flags as typed; empty texts leave the importer's own choice.
struct InputFlags {
  std::vector<std::string> inputs;
  std::string frame;
  std::string sides;  ///< what to do about sides that are not certain
  std::string smooth;
  std::string unit;
  double decimateMm = 0;  ///< 0: not at all
  std::string overlay;
  std::string assembly;
  std::vector<std::string> thresholds;
  bool keepScans = false;
  bool together = false;  ///< make one scene of several patients
  bool keepFileNames = false;
  bool verbose = false;  ///< report each surface that was repaired
};

/// Returns what is to be done about sides that are not certain, if anything is.
Result<std::optional<model::SideAnswer>> parseSides(const std::string& text);

/// Returns the importer's options; an error counts as wrong use.
Result<model::ImportOptions> importOptions(const InputFlags& flags);

/// Imports with progress on a terminal, settles the sides as the flags ask, and passes each warning
/// and note on to standard error.
Result<model::Imported> readInputs(const InputFlags& flags, const model::ImportOptions& options,
                                   Progress& progress);

/// Tells on standard error, once, where sides are not certain: why, and what can be done. For who
/// shows or keeps the scene; measures have no sides.
void warnOfSides(const model::Scene& scene);

/// Opens a scene file to look at or change it; passes its warnings on likewise.
Result<model::SceneDocument> openedScene(const std::string& file);

}  // namespace sline::cli
