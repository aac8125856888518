// SPDX-License-Identifier: Apache-2.0
// Loads files into parts: surfaces as their files have them, mended.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/progress_meter.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Holds a scan that a file contains.
struct ReadScan {
  std::size_t file = 0;  ///< in Sources::files
  RawScan raw;
};

/// Holds the data that files gave.
struct LoadedParts {
  std::vector<Part> parts;
  std::vector<ReadScan> scans;  ///< filled where the options keep scans
  std::vector<ImportWarning> warnings;
  std::vector<std::string> notes;
  std::vector<LeftOutTwin> twins;  ///< where surfaces are silent about their frame
};

/// Reads and mends all files; parts come in the files' order. A failure becomes a warning.
LoadedParts loadParts(const Sources& sources, const ImportOptions& options, ProgressMeter& meter);

/// Reads one file, or those that are read together with it; `number` is not set.
LoadedParts loadFile(const Sources& sources, std::size_t file, const ImportOptions& options,
                     ProgressMeter& meter);

/// Makes the structures that the options' thresholds select in a scan that was read before, as
/// loadFile would.
LoadedParts loadScan(const Sources& sources, const ReadScan& scan, const ImportOptions& options,
                     ProgressMeter& meter);

/// Sets Part::number by the order of the parts.
void numberParts(std::vector<Part>& parts);

/// Returns names for the surfaces of one file that tell them apart, by which they are found again
/// later.
std::vector<std::string> partNames(const std::vector<RawMesh>& meshes);

}  // namespace sline::model
