// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/read_inputs.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "model/import/plan/patients.h"
#include "model/import/plan/scene_inputs.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

bool sameLimits(const ReadLimits& a, const ReadLimits& b) {
  return a.fileBytes == b.fileBytes && a.vertices == b.vertices && a.triangles == b.triangles;
}

/// Collects the sources; fails where they are not of one patient, and need be.
Status collect(ReadInputs& read, const std::vector<fs::path>& meshes,
               const std::vector<TracedScene>& scenes, ScansWanted wanted) {
  const ImportOptions& options = read.options;
  const bool asked = !options.thresholds.empty() || options.keepScans;
  const bool slices = asked || wanted == ScansWanted::all;
  read.sources =
      collectSources(meshes, options.limits, slices ? ScannerSlices::read : ScannerSlices::leftOut);
  read.traces = TRY(admitPatients(read.sources, scenes, options));
  return Unit{};
}

Status readMeshes(ReadInputs& read, ScansWanted scans, const ImportProgress& progress) {
  ImportOptions options = read.options;
  ProgressMeter meter(progress, bytesOf(read.sources));
  // The user decides what to make of a scan by looking at it.
  options.keepScans = options.keepScans || scans == ScansWanted::all;
  LoadedParts loaded = loadParts(read.sources, options, meter);
  read.parts = std::move(loaded.parts);
  read.scans = std::move(loaded.scans);
  read.warnings = std::move(loaded.warnings);
  read.notes = std::move(loaded.notes);
  read.twins = std::move(loaded.twins);
  if (meter.cancelled())
    return Error{.reason = "the import was cancelled"};
  std::vector<ImportWarning> all = read.sources.warnings;
  all.insert(all.end(), read.warnings.begin(), read.warnings.end());
  if (read.parts.empty() && read.scans.empty() && !haveFiducials(read.sources))
    return nothingRead(read.sources, all);
  return Unit{};
}

/// Reads all parts of the file; those of scans are made from the scans in memory.
std::vector<Part> readAgain(const ReadInputs& read, std::size_t file, const ImportOptions& options,
                            ProgressMeter& meter) {
  const bool scanned = std::any_of(read.scans.begin(), read.scans.end(),
                                   [&](const ReadScan& scan) { return scan.file == file; });
  const bool together = !read.sources.files[file].together.empty();
  if (!scanned || together)
    return loadFile(read.sources, file, options, meter).parts;
  std::vector<Part> parts;
  for (const ReadScan& scan : read.scans)
    if (scan.file == file)
      for (Part& part : loadScan(read.sources, scan, options, meter).parts)
        parts.push_back(std::move(part));
  return parts;
}

}  // namespace

bool ReadInputs::holdsFor(std::span<const fs::path> others, const ImportOptions& with) const {
  return !emptied && std::equal(others.begin(), others.end(), inputs.begin(), inputs.end()) &&
         options.repair == with.repair && options.assembly == with.assembly &&
         options.patients == with.patients && options.keepFileNames == with.keepFileNames &&
         options.memoryBytes == with.memoryBytes && sameLimits(options.limits, with.limits);
}

Result<ReadInputs> readInputs(std::span<const fs::path> inputs, const ImportOptions& options,
                              ScansWanted scans, const ImportProgress& progress) {
  ReadInputs read{.inputs = {inputs.begin(), inputs.end()}, .options = options};
  std::vector<fs::path> meshes;
  std::vector<fs::path> scenes;
  for (const fs::path& input : inputs)
    (isSceneFile(input) ? scenes : meshes).push_back(input);
  std::vector<TracedScene> traced;
  if (!scenes.empty()) {
    // The effect of other options on scenes is reported when decisions are made.
    OpenedScenes opened =
        TRY(openScenes(scenes, {.patients = options.patients, .into = options.into}));
    read.scenes = std::move(opened.all);
    traced = std::move(opened.traced);
    if (meshes.empty())
      return read;
  }
  TRY(collect(read, meshes, traced, scans));
  if (const Status done = readMeshes(read, scans, progress); !done.ok()) {
    if (scenes.empty())
      return done.error();
    Error error = done.error();
    const std::string file = std::exchange(error.file, "");
    read.warnings = {{file, error.text()}};
    read.sources = {};
  }
  return read;
}

Result<ReadInputs> withThresholds(const ReadInputs& read, const std::vector<Threshold>& thresholds,
                                  const ImportProgress& progress) {
  ReadInputs again = read;
  again.options.thresholds = thresholds;
  std::erase_if(again.parts, [](const Part& part) { return part.raw.threshold.has_value(); });
  const auto ofScan = [&](const std::string& file) {
    return std::any_of(read.scans.begin(), read.scans.end(),
                       [&](const ReadScan& scan) { return scan.raw.file == file; });
  };
  std::erase_if(again.warnings, [&](const ImportWarning& w) { return ofScan(w.file); });
  std::erase_if(again.notes,
                [&](const std::string& note) { return ofScan(note.substr(0, note.find(": "))); });
  ProgressMeter meter(progress, double(again.scans.size()));
  for (const ReadScan& scan : again.scans) {
    LoadedParts loaded = loadScan(again.sources, scan, again.options, meter);
    meter.add(1.0, scan.raw.file);
    std::move(loaded.parts.begin(), loaded.parts.end(), std::back_inserter(again.parts));
    std::move(loaded.warnings.begin(), loaded.warnings.end(), std::back_inserter(again.warnings));
    std::move(loaded.notes.begin(), loaded.notes.end(), std::back_inserter(again.notes));
  }
  if (meter.cancelled())
    return Error{.reason = "the import was cancelled"};
  numberParts(again.parts);
  return again;
}

void readAsSmoothed(std::vector<Part>& parts, const ReadInputs& read, const Smoothing& smoothing,
                    ProgressMeter& meter, std::vector<ImportWarning>& warnings) {
  struct Reading {
    std::size_t file;
    Smoothing smoothing;
    std::vector<Part*> parts;
  };
  std::vector<Reading> readings;
  for (Part& part : parts) {
    const Smoothing asked = part.choice.smoothing.value_or(smoothing);
    if (!part.raw.smooth || part.raw.molecule || part.choice.skipped ||
        asked == read.options.smoothing)
      continue;
    const auto same = std::find_if(readings.begin(), readings.end(), [&](const Reading& r) {
      return r.file == part.file && r.smoothing == asked;
    });
    if (same != readings.end())
      same->parts.push_back(&part);
    else
      readings.push_back({part.file, asked, {&part}});
  }
  for (const Reading& reading : readings) {
    ImportOptions options = read.options;
    options.smoothing = reading.smoothing;
    std::vector<Part> found = readAgain(read, reading.file, options, meter);
    if (meter.cancelled())
      return;
    for (Part* part : reading.parts) {
      const auto again = std::find_if(found.begin(), found.end(),
                                      [&](const Part& p) { return p.surface == part->surface; });
      if (again == found.end()) {
        part->choice.skipped = true;
        warnings.push_back(
            {part->provenance.file,
             "\"" + part->name + "\" was left out: its file has changed or is gone"});
        continue;
      }
      part->raw.positions = again->raw.positions;
      part->raw.triangles = again->raw.triangles;
      part->raw.displacement = again->raw.displacement;
      part->raw.sliceDistance = again->raw.sliceDistance;
      part->provenance.fingerprint = again->provenance.fingerprint;
    }
  }
}

}  // namespace sline::model
