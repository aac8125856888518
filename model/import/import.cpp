// SPDX-License-Identifier: Apache-2.0
#include "model/import/import.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <utility>

#include "model/files/scene_file.h"
#include "model/import/anatomy_names.h"
#include "model/import/folder_tree.h"
#include "model/import/frame_and_unit.h"
#include "model/import/overlay.h"
#include "model/import/parts.h"
#include "model/import/repair_notes.h"
#include "model/import/scene_inputs.h"
#include "model/import/sources.h"
#include "model/import/views_and_annotations.h"

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
  const Sources sources = collectSources(inputs, options.limits);
  report.warnings = sources.warnings;
  ProgressMeter meter(progress, expectedWork(sources, options));

  std::vector<Part> parts = loadParts(sources, options, meter, report.warnings);
  if (meter.cancelled())
    return cancelled;
  if (parts.empty() && !haveFiducials(sources))
    return nothingRead(sources, report.warnings);
  report.notes = overlayMolecules(parts, options.overlay);
  report.repairs = repairNotes(parts, sources);
  decideFrames(parts, sources, options, report);
  decideUnits(parts, sources, options, report);
  smoothParts(parts, sources, options.smoothing, meter);
  if (meter.cancelled())
    return cancelled;
  placeParts(parts, sources, report.warnings);
  if (options.decimateMm > 0.0f)
    decimateParts(parts, options.decimateMm, meter);
  if (meter.cancelled())
    return cancelled;
  if (parts.empty() && !haveFiducials(sources))
    return nothingRead(sources, report.warnings);
  imported.scene =
      withViewsAndAnnotations(buildScene(std::move(parts), sources, table), sources, options.frame);
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
