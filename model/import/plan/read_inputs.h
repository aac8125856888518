// SPDX-License-Identifier: Apache-2.0
// Holds the contents of inputs before anything is decided about them, kept so that other decisions
// need no second reading.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "model/import/plan/load_parts.h"
#include "model/import/plan/sources.h"

namespace sline::model {

struct ReadInputs {
  std::vector<std::filesystem::path> inputs;
  ImportOptions options;  ///< limits, repair and smoothing as they were at the time of reading
  Sources sources;
  std::vector<Part> parts;              ///< in their files' coordinates, by Part::number
  std::vector<ReadScan> scans;          ///< kept or not, as they were wanted
  std::vector<ImportWarning> warnings;  ///< from reading the surfaces
  std::vector<std::string> notes;
  std::vector<LeftOutTwin> twins;   ///< as in LoadedParts
  std::optional<Imported> scenes;   ///< from scene files among the inputs
  std::vector<SourceTrace> traces;  ///< of what was read, for the scene that is made of it
  bool emptied = false;             ///< of what was read only the names are left

  /// Tells whether reading with these inputs and options would give the same; apart from smoothing,
  /// which only some readers do, and thresholds.
  bool holdsFor(std::span<const std::filesystem::path> others, const ImportOptions& with) const;
};

/// Says which scans are read: those that the options make structures of or keep, or all there are,
/// because structures might be made of them later.
enum class ScansWanted { asAsked, all };

/// Reads the inputs; the error is that of importInputs.
Result<ReadInputs> readInputs(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, ScansWanted scans,
                              const ImportProgress& progress);

/// Returns the inputs with other thresholds: scans are in memory and are not read again.
Result<ReadInputs> withThresholds(const ReadInputs& read, const std::vector<Threshold>& thresholds,
                                  const ImportProgress& progress);

/// Reads again the parts with readers that smooth and are asked to smooth otherwise than `read`
/// was. A surface that its file no longer holds is left out, with a warning.
void readAsSmoothed(std::vector<Part>& parts, const ReadInputs& read, const Smoothing& smoothing,
                    ProgressMeter& meter, std::vector<ImportWarning>& warnings);

}  // namespace sline::model
