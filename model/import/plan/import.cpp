// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/import.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <algorithm>
#include <utility>

#include "model/files/scene_file.h"
#include "model/import/naming/anatomy_names.h"
#include "model/import/plan/folder_tree.h"
#include "model/import/plan/frame_and_unit.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/overlay.h"
#include "model/import/plan/parts.h"
#include "model/import/plan/repair_notes.h"
#include "model/import/plan/scene_inputs.h"
#include "model/import/plan/sources.h"
#include "model/import/plan/views_and_annotations.h"

namespace sline::model {

namespace {

double expectedWork(const Sources& sources, const ImportOptions& options) {
  constexpr double share = 0.4;  // of a file's bytes: workPerTriangle times its triangles
  const double bytes = bytesOf(sources);
  return bytes + (options.smoothing.mode == Smoothing::Mode::off ? 0.0 : share * bytes) +
         (options.decimateMm > 0.0f ? share * bytes : 0.0);
}

Result<Imported> importMeshes(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  const Error cancelled{.reason = "the import was cancelled"};
  const AnatomyTable table;
  Imported imported;
  ImportReport& report = imported.report;
  const bool asked = !options.thresholds.empty() || options.keepScans;
  const Sources sources =
      collectSources(inputs, options.limits, asked ? ScannerSlices::read : ScannerSlices::leftOut);
  report.warnings = sources.warnings;
  ProgressMeter meter(progress, expectedWork(sources, options));

  Loaded loaded = loadParts(sources, options, meter);
  std::vector<Part> parts = std::move(loaded.parts);
  const auto take = [](auto& to, auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  take(report.warnings, loaded.warnings);
  if (meter.cancelled())
    return cancelled;
  const auto made = [](const Part& part) { return part.raw.threshold.has_value(); };
  if (!options.thresholds.empty() && std::none_of(parts.begin(), parts.end(), made))
    report.warnings.push_back({"", "no threshold made a structure: no scan was read that has it"});
  const bool more = haveFiducials(sources) || !loaded.scans.empty();
  if (parts.empty() && !more)
    return nothingRead(sources, report.warnings);
  report.notes = overlayMolecules(parts, options.overlay);
  take(report.notes, loaded.notes);
  report.repairs = repairNotes(parts, sources);
  decideFrames(parts, sources, options, report);
  decideUnits(parts, sources, options, report);
  std::vector<Scan> scans = keptScans(loaded.scans, parts, options, report);
  smoothParts(parts, sources, options.smoothing, meter);
  if (meter.cancelled())
    return cancelled;
  placeParts(parts, sources, report.warnings);
  if (options.decimateMm > 0.0f)
    decimateParts(parts, options.decimateMm, meter);
  if (meter.cancelled())
    return cancelled;
  if (parts.empty() && !more)
    return nothingRead(sources, report.warnings);
  imported.scene =
      withViewsAndAnnotations(buildScene(std::move(parts), sources, table), sources, options.frame);
  imported.scene.setScans(std::move(scans));
  // Hundreds of files' intermediate copies are free now; the system may have them back.
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  return imported;
}

}  // namespace

Result<Imported> importInputs(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  std::vector<std::filesystem::path> meshes;
  std::vector<std::filesystem::path> scenes;
  for (const std::filesystem::path& input : inputs)
    (isSceneFile(input) ? scenes : meshes).push_back(input);
  if (scenes.empty())
    return importMeshes(inputs, options, progress);
  Result<Imported> imported = openScenes(scenes, options);
  if (meshes.empty() || !imported.ok())
    return imported;
  Result<Imported> added = importMeshes(meshes, options, progress);
  if (added.ok()) {
    append(*imported, std::move(*added));
  } else {
    Error error = added.error();
    const std::string file = std::exchange(error.file, "");
    imported->report.warnings.push_back({file, error.text()});
  }
  return imported;
}

}  // namespace sline::model
