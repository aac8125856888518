// SPDX-License-Identifier: Apache-2.0
// Opens a volume file as its header describes it, before its voxels are unpacked: labels or
// intensities are made from the same numbers at the same place.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "model/import/source/source.h"
#include "model/import/volumes/formats/label_names.h"
#include "model/import/volumes/formats/voxel_stream.h"

namespace sline::model {

struct VolumeFile {
  VoxelLayout layout;
  VoxelBytes stored;                                   ///< in one of `sources`
  std::vector<std::shared_ptr<const Source>> sources;  ///< the header's, the voxels'
  glm::dmat4 toLps{1.0};                               ///< as LabelVolume has it, with the reasons
  std::optional<Frame> frame;
  std::string frameReason;
  std::string unitReason;
  bool onlySideOpen = false;  ///< as RawMesh::onlySideOpen
  /// Returns the names of a layer's labels, if there are any; asked once its voxels are there.
  std::function<LabelNames(const LabelVolume& volume, std::size_t layer)> names;
  bool layersMeant = false;  ///< its layers are structures that overlap, rather than points in time
  std::vector<ImportWarning> warnings;
};

/// Opens NIfTI-1 and -2, one file (.nii) or two (.hdr and .img, either of which is named), packed
/// or not: lengths by the header's unit, place by sform, else qform, else the voxel sizes alone,
/// names from a LabelTable in the header extension. Two files without a word of NIfTI are read as
/// Analyze 7.5.
Result<VolumeFile> openNifti(const std::filesystem::path& file, const ReadOptions& options);
/// Opens NRRD of any version, attached or detached, raw, text, hex, gzip or bzip2, with segments as
/// 3D Slicer describes them in .seg.nrrd.
Result<VolumeFile> openNrrd(const std::filesystem::path& file, const ReadOptions& options);
/// Opens MetaImage, attached or detached, packed or not.
Result<VolumeFile> openMetaImage(const std::filesystem::path& file, const ReadOptions& options);
/// Opens FreeSurfer's MGH, packed (.mgz) or not: place by the directions in the header, names from
/// the colour table behind the voxels.
Result<VolumeFile> openMgh(const std::filesystem::path& file, const ReadOptions& options);
/// Opens MINC 1.
Result<VolumeFile> openMinc(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
