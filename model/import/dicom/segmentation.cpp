// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segmentation.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/import/dicom/segmentation_reader.h"
#include "model/import/volumes/label_surfaces.h"

namespace sline::model {

Result<LabelVolumes> segmentationVolumes(const DicomFile& file, const ReadOptions& options) {
  return SegmentationReader(file, options).read();
}

Result<RawMeshes> segmentationSurfaces(const DicomFile& file, const ReadOptions& options) {
  LabelVolumes volumes = TRY(segmentationVolumes(file, options));
  // A mask of noise has more surface than any organ: the limits of a file grow with its bytes.
  ReadOptions bounded = options;
  const std::uint64_t most = 2'000'000 + 2 * std::uint64_t(file.source().size());
  bounded.limits.vertices = std::min(options.limits.vertices, most);
  bounded.limits.triangles = std::min(options.limits.triangles, 2 * most);
  RawMeshes result;
  result.warnings = std::move(volumes.warnings);
  for (LabelVolume& volume : volumes.volumes) {
    Result<RawMeshes> surfaces = labelSurfaces(volume, bounded);
    if (!surfaces) {
      Error error = surfaces.error();
      error.file = file.source().file();
      return error;
    }
    volume = {};
    for (RawMesh& mesh : surfaces->meshes) {
      mesh.origin = "DICOM segmentation";
      result.meshes.push_back(std::move(mesh));
    }
    std::move(surfaces->warnings.begin(), surfaces->warnings.end(),
              std::back_inserter(result.warnings));
  }
  if (result.meshes.empty())
    return file.source().whole("none of its segments that are described has a pixel",
                               "Export the segmentation again");
  return result;
}

}  // namespace sline::model
