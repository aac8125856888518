// SPDX-License-Identifier: Apache-2.0
#include "model/import/read_inputs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "model/files/scene_file.h"
#include "model/import/scene_inputs.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

bool sameLimits(const ReadLimits& a, const ReadLimits& b) {
  return a.fileBytes == b.fileBytes && a.vertices == b.vertices && a.triangles == b.triangles;
}

Status readMeshes(ReadInputs& read, const std::vector<fs::path>& meshes,
                  const ImportProgress& progress) {
  read.sources = collectSources(meshes, read.options.limits);
  ProgressMeter meter(progress, bytesOf(read.sources));
  read.parts = loadParts(read.sources, read.options, meter, read.warnings);
  if (meter.cancelled())
    return Error{.reason = "the import was cancelled"};
  std::vector<ImportWarning> all = read.sources.warnings;
  all.insert(all.end(), read.warnings.begin(), read.warnings.end());
  if (read.parts.empty() && !haveFiducials(read.sources))
    return nothingRead(read.sources, all);
  return Unit{};
}

}  // namespace

bool ReadInputs::holdsFor(std::span<const fs::path> others, const ImportOptions& with) const {
  return std::equal(others.begin(), others.end(), inputs.begin(), inputs.end()) &&
         options.repair == with.repair && options.assembly == with.assembly &&
         sameLimits(options.limits, with.limits);
}

Result<ReadInputs> readInputs(std::span<const fs::path> inputs, const ImportOptions& options,
                              const ImportProgress& progress) {
  ReadInputs read{.inputs = {inputs.begin(), inputs.end()}, .options = options};
  std::vector<fs::path> meshes;
  std::vector<fs::path> scenes;
  for (const fs::path& input : inputs)
    (isSceneFile(input) ? scenes : meshes).push_back(input);
  if (!scenes.empty()) {
    // What the options mean for scenes is told when something is decided.
    Result<Imported> opened = openScenes(scenes, {});
    if (!opened.ok())
      return opened.error();
    read.scenes = std::move(*opened);
    if (meshes.empty())
      return read;
  }
  if (const Status done = readMeshes(read, meshes, progress); !done.ok()) {
    if (scenes.empty())
      return done.error();
    Error error = done.error();
    const std::string file = std::exchange(error.file, "");
    read.warnings = {{file, error.text()}};
    read.sources = {};
  }
  return read;
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
    std::vector<ImportWarning> sameAsBefore;
    std::vector<Part> found = loadFile(read.sources, reading.file, options, meter, sameAsBefore);
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
      part->provenance.fingerprint = again->provenance.fingerprint;
    }
  }
}

}  // namespace sline::model
