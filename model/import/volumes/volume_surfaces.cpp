// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/volume_surfaces.h"

#include <algorithm>
#include <iterator>
#include <new>

#include "model/import/volumes/label_surfaces.h"
#include "model/import/volumes/threshold_surface.h"
#include "model/import/volumes/volume_readers.h"

namespace sline::model {

namespace {

/// Bounds the options: real segmentations have up to three vertices for each packed byte, small
/// ones fewer than a million in all.
ReadOptions boundedBy(ReadOptions options, std::uint64_t bytes) {
  options.limits.vertices = std::min(options.limits.vertices, (std::uint64_t(1) << 20) + 2 * bytes);
  options.limits.triangles =
      std::min(options.limits.triangles, (std::uint64_t(1) << 22) + 8 * bytes);
  return options;
}

/// Spends a part of the limit; layers share the budget of their file.
void spend(std::uint64_t& limit, std::size_t count) {
  limit -= std::min<std::uint64_t>(limit, count);
}

}  // namespace

Result<RawMeshes> volumeSurfaces(const LabelVolumes& volumes, std::uint64_t bytes,
                                 const ReadOptions& options) {
  ReadOptions bounded = boundedBy(options, bytes);
  RawMeshes all;
  all.warnings = volumes.warnings;
  std::optional<Error> empty;
  for (const LabelVolume& volume : volumes.volumes) {
    if (volume.labels.empty()) {
      empty = Error{
          {}, {}, "the volume holds nothing but background", "Choose a volume with structures"};
      continue;
    }
    RawMeshes surfaces = TRY(labelSurfaces(volume, bounded));
    for (const RawMesh& mesh : surfaces.meshes) {
      spend(bounded.limits.vertices, mesh.positions.size());
      spend(bounded.limits.triangles, mesh.triangles.size());
    }
    all.thereAlready += surfaces.thereAlready;
    std::move(surfaces.meshes.begin(), surfaces.meshes.end(), std::back_inserter(all.meshes));
    std::move(surfaces.warnings.begin(), surfaces.warnings.end(), std::back_inserter(all.warnings));
  }
  if (all.meshes.empty() && all.thereAlready == 0 && empty)
    return *empty;
  return all;
}

Result<RawMeshes> scanSurfaces(const RawScan& scan, const ReadOptions& options) {
  RawMeshes all;
  std::optional<Error> first;
  for (const Threshold& threshold : options.thresholds) {
    if (!threshold.scan.empty() && threshold.scan != scan.file)
      continue;
    Result<ThresholdSurface> made = thresholdSurface(*scan.volume, threshold, options);
    if (!made) {
      first = first.value_or(made.error());
      all.warnings.push_back({scan.file, made.error().text()});
      continue;
    }
    made->mesh.file = scan.file;
    all.meshes.push_back(std::move(made->mesh));
    for (const std::string& note : made->notes)
      all.notes.push_back(scan.file + ": " + note);
  }
  if (options.keepScans)
    all.scans.push_back(scan);
  if (all.meshes.empty() && all.scans.empty() && first)
    return *first;
  return all;
}

Result<RawMeshes> readVolumeSurfaces(const std::filesystem::path& file,
                                     const ReadOptions& options) {
  const auto named = [&](Error error) {
    if (error.file.empty())
      error.file = file.string();
    return error;
  };
  try {
    Result<VolumeRead> read = readVolume(file, options);
    if (!read)
      return named(read.error());
    std::error_code code;
    const std::uintmax_t bytes = std::filesystem::file_size(file, code);
    if (!read->scan.volume) {
      Result<RawMeshes> surfaces = volumeSurfaces(read->labels, code ? 0 : bytes, options);
      return surfaces ? std::move(surfaces) : named(surfaces.error());
    }
    Result<RawMeshes> surfaces =
        scanSurfaces({file.filename().string(), std::move(read->scan.volume)},
                     boundedBy(options, code ? 0 : bytes));
    if (!surfaces)
      return named(surfaces.error());
    std::move(read->scan.warnings.begin(), read->scan.warnings.end(),
              std::back_inserter(surfaces->warnings));
    std::move(read->scan.notes.begin(), read->scan.notes.end(),
              std::back_inserter(surfaces->notes));
    return surfaces;
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "needs more memory than there is", "Close other programs"};
  }
}

}  // namespace sline::model
