// SPDX-License-Identifier: Apache-2.0
// What a reader is told besides the file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/meshing/smoothing.h"

namespace sline::model {

/// Limits every reader keeps, so that a small file cannot ask for a large machine.
struct ReadLimits {
  std::uint64_t fileBytes = std::uint64_t(4) << 30;
  std::uint64_t vertices = 100'000'000;
  std::uint64_t triangles = 200'000'000;
  /// Of a reader in a process of its own (worker/reading_child.h). 0: half of the machine's memory,
  /// and a minute with a second for each megabyte of the file.
  std::uint64_t childBytes = 0;
  std::uint64_t childSeconds = 0;
};

/// A structure to be made of a scan: all that has an intensity within bounds. A name of the table
/// of presets (volumes/threshold_presets.h) brings bounds, where none are given, and how it is
/// treated.
struct Threshold {
  std::string name;
  std::optional<double> low;  ///< Hounsfield units where the scan has them
  std::optional<double> high;
  std::string scan = {};  ///< of the file or folder of that name alone; empty: of all scans
  bool operator==(const Threshold&) const = default;
};

struct ReadOptions {
  ReadLimits limits;
  Smoothing smoothing;  ///< for readers that make their surfaces themselves (RawMesh::smooth)
  std::string
      assembly;  ///< of molecules: the biological assembly to make; empty: what the file has
  /// Asked now and then in a long piece of work, from any thread; false to give up, with an error
  /// that nobody will see.
  std::function<bool()> goesOn = [] { return true; };
  std::vector<Threshold> thresholds = {};  ///< what to make of each scan
  bool keepScans = false;                  ///< hand scans themselves on, too (RawMeshes::scans)
};

}  // namespace sline::model
