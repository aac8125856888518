// SPDX-License-Identifier: Apache-2.0
// Defines what a reader is told besides the file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/meshing/smoothing.h"

namespace sline::model {

/// Holds limits that every reader keeps, so that a small file cannot ask for a large machine.
struct ReadLimits {
  std::uint64_t fileBytes = std::uint64_t(4) << 30;
  std::uint64_t vertices = 100'000'000;
  std::uint64_t triangles = 200'000'000;
  /// Limits a reader in a process of its own (worker/reading_child.h). 0 means half of the
  /// machine's memory, and a minute with a second for each megabyte of the file.
  std::uint64_t childBytes = 0;
  std::uint64_t childSeconds = 0;
};

/// Describes a structure to be made of a scan: everything that has an intensity within bounds. A
/// name in the table of presets (volumes/threshold_presets.h) brings bounds, where none are given,
/// and decides how the structure is treated.
struct Threshold {
  std::string name;
  std::optional<double> low;  ///< Hounsfield units where the scan has them
  std::optional<double> high;
  std::string scan = {};  ///< only the scan of the file or folder of that name; empty: all scans
  bool operator==(const Threshold&) const = default;
};

struct ReadOptions {
  ReadLimits limits;
  Smoothing smoothing;   ///< for readers that make their surfaces themselves (RawMesh::smooth)
  std::string assembly;  ///< for molecules: the biological assembly to make; empty: as in the file
  /// Is asked now and then in a long piece of work, from any thread; returning false gives up, with
  /// an error that is never shown.
  std::function<bool()> goesOn = [] { return true; };
  std::vector<Threshold> thresholds = {};  ///< structures to make of each scan
  bool keepScans = false;                  ///< hand scans themselves on, too (RawMeshes::scans)
  /// Tells that a structure of a label volume, by its name in the file, is there already and need
  /// not be made: to the others it is background. May be asked from any thread.
  std::function<bool(const std::string&)> isThere = [](const std::string&) { return false; };
};

}  // namespace sline::model
