// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/volume_surfaces.h"

#include <algorithm>
#include <new>

#include "model/import/volumes/label_surfaces.h"
#include "model/import/volumes/volume_readers.h"

namespace sline::model {

namespace {

/// Layers share what their file is allowed.
void spend(std::uint64_t& limit, std::size_t count) {
  limit -= std::min<std::uint64_t>(limit, count);
}

}  // namespace

Result<RawMeshes> volumeSurfaces(const LabelVolumes& volumes, std::uint64_t bytes,
                                 const ReadOptions& options) {
  // Real segmentations have up to three vertices for each packed byte, small ones fewer than a
  // million in all.
  ReadOptions bounded = options;
  bounded.limits.vertices = std::min(options.limits.vertices, (std::uint64_t(1) << 20) + 2 * bytes);
  bounded.limits.triangles =
      std::min(options.limits.triangles, (std::uint64_t(1) << 22) + 8 * bytes);
  RawMeshes all;
  all.warnings = volumes.warnings;
  std::optional<Error> empty;
  for (const LabelVolume& volume : volumes.volumes) {
    if (volume.labels.empty()) {
      empty = Error{
          {}, {}, "the volume holds nothing but background", "Choose a volume with structures"};
      continue;
    }
    Result<RawMeshes> surfaces = labelSurfaces(volume, bounded);
    if (!surfaces)
      return surfaces.error();
    for (const RawMesh& mesh : surfaces->meshes) {
      spend(bounded.limits.vertices, mesh.positions.size());
      spend(bounded.limits.triangles, mesh.triangles.size());
    }
    std::move(surfaces->meshes.begin(), surfaces->meshes.end(), std::back_inserter(all.meshes));
    std::move(surfaces->warnings.begin(), surfaces->warnings.end(),
              std::back_inserter(all.warnings));
  }
  if (all.meshes.empty() && empty)
    return *empty;
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
    const Result<LabelVolumes> volumes = readVolume(file, options);
    if (!volumes)
      return named(volumes.error());
    std::error_code code;
    const std::uintmax_t bytes = std::filesystem::file_size(file, code);
    Result<RawMeshes> surfaces = volumeSurfaces(*volumes, code ? 0 : bytes, options);
    if (!surfaces)
      return named(surfaces.error());
    return surfaces;
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "needs more memory than there is", "Close other programs"};
  }
}

}  // namespace sline::model
