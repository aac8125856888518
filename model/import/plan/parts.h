// SPDX-License-Identifier: Apache-2.0
// Surfaces under way from their files to the scene.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "model/import/plan/import.h"
#include "model/import/plan/sources.h"
#include "model/meshing/repair.h"
#include "model/meshing/smoothing.h"
#include "model/scene/scene.h"

namespace sline::model {

/// What was decided by hand for one surface; what is open is as for all.
struct PartChoice {
  std::optional<Frame> frame;
  std::optional<float> unit;
  std::optional<Smoothing> smoothing;
  std::optional<float> decimateMm;
  bool skipped = false;  ///< it is neither smoothed nor decimated, but tells of the others' grid
};

/// One surface. `raw` holds positions and triangles until `mesh` takes them.
struct Part {
  std::size_t file = 0;    ///< in Sources::files
  std::size_t number = 0;  ///< among all that were read
  std::string surface;     ///< which of its file's, as partNames has it
  std::string name;
  RawMesh raw;
  SurfaceMeasure measure;
  RepairReport repair;
  Frame frame = Frame::lps;
  float unit = 1.0f;  ///< millimetres per unit, a guessed one included
  Provenance provenance;
  MeshPtr mesh;
  PartChoice choice;
};

/// A scan that a file holds.
struct ReadScan {
  std::size_t file = 0;  ///< in Sources::files
  RawScan raw;
};

/// What files gave.
struct Loaded {
  std::vector<Part> parts;
  std::vector<ReadScan> scans;  ///< where options keep them
  std::vector<ImportWarning> warnings;
  std::vector<std::string> notes;
};

/// What smoothing or decimating a triangle takes, where reading a byte takes 1.
inline constexpr double workPerTriangle = 6.0;

/// Counts what is done and asks the user's function whether to go on; any thread may call it.
class ProgressMeter {
 public:
  ProgressMeter(const ImportProgress& progress, double total)
      : m_progress(progress), m_total(total) {}
  void add(double amount, const std::string& what);
  /// Asks in the middle of a long piece of work; false to give up.
  bool goesOn(const std::string& what) {
    add(0.0, what);
    return !m_cancelled;
  }
  bool cancelled() const { return m_cancelled; }

 private:
  const ImportProgress& m_progress;
  double m_total;
  std::mutex m_mutex;
  double m_done = 0.0;
  std::atomic<bool> m_cancelled = false;
};

/// Calls body(i) for i in `order`, a few at a time only, so that memory stays bounded; stops early
/// where the meter says so.
void forFewAtATime(const std::vector<std::size_t>& order, const ProgressMeter& meter,
                   const std::function<void(std::size_t)>& body);

/// Reads and mends all files; parts come in the files' order. What fails becomes a warning.
Loaded loadParts(const Sources& sources, const ImportOptions& options, ProgressMeter& meter);

/// Reads one file, or those that are read together with it; `number` is not set.
Loaded loadFile(const Sources& sources, std::size_t file, const ImportOptions& options,
                ProgressMeter& meter);

/// The structures that the thresholds of the options make of a scan that was read before, as
/// loadFile would.
Loaded loadScan(const Sources& sources, const ReadScan& scan, const ImportOptions& options,
                ProgressMeter& meter);

/// As Part::number, by their order.
void numberParts(std::vector<Part>& parts);

/// Smooths and refines each part by the grid it shares with the parts of its source, as `smoothing`
/// asks or its own choice.
void smoothParts(std::vector<Part>& parts, const Sources& sources, const Smoothing& smoothing,
                 ProgressMeter& meter);

/// Surfaces of one file under names that tell them apart, by which they are found again later.
std::vector<std::string> partNames(const std::vector<RawMesh>& meshes);

/// The surface in millimetres LPS, by the frame, unit and transform that are told of it. Its
/// displacement is scaled with it.
Result<MeshPtr> placedMesh(RawMesh raw, Provenance& as);

/// Brings each part to millimetres LPS by its frame, unit and transform, and makes its mesh.
void placeParts(std::vector<Part>& parts, const Sources& sources,
                std::vector<ImportWarning>& warnings);

/// Fewer triangles within `bound` mm or the part's own bound (meshing/simplification.h); 0: all.
void decimateParts(std::vector<Part>& parts, float bound, ProgressMeter& meter);

}  // namespace sline::model
