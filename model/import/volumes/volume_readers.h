// SPDX-License-Identifier: Apache-2.0
// One function per volume format: a file → the label volumes in it, each layer of overlapping
// segments one, with names and colours from the header or a table beside the file. Data in a file
// of their own are read only from the header's folder. What the readers promise of errors and
// memory is what readers/readers.h says; voxels are refused where the file's bytes do not justify
// them, and where they are an image's (see decodeVoxels).
#pragma once

#include <filesystem>

#include "model/import/read_options.h"
#include "model/import/volumes/label_volume.h"

namespace sline::model {

/// The reader of the name's ending.
Result<LabelVolumes> readVolume(const std::filesystem::path& file, const ReadOptions& options);

/// NIfTI-1 and -2, one file (.nii) or two (.hdr and .img, of which either is named), packed or not:
/// lengths by the header's unit, place by sform, else qform, else the voxel sizes alone, names from
/// a LabelTable in the header extension. Two files without a word of NIfTI are read as Analyze 7.5.
Result<LabelVolumes> readNifti(const std::filesystem::path& file, const ReadOptions& options);
/// FreeSurfer's MGH, packed (.mgz) or not: place by the directions in the header, names from the
/// colour table behind the voxels.
Result<LabelVolumes> readMgh(const std::filesystem::path& file, const ReadOptions& options);
/// NRRD of any version, attached or detached, raw, text, hex, gzip or bzip2; segments as 3D Slicer
/// describes them in .seg.nrrd.
Result<LabelVolumes> readNrrd(const std::filesystem::path& file, const ReadOptions& options);
/// MetaImage, attached or detached, packed or not.
Result<LabelVolumes> readMetaImage(const std::filesystem::path& file, const ReadOptions& options);
/// MINC 1.
Result<LabelVolumes> readMinc(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
