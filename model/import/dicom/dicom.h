// SPDX-License-Identifier: Apache-2.0
// The door to DICOM: which objects hold segmentations, who makes surfaces of them, and who makes
// volumes of the slices of scanners. Of a patient nothing gets through it: shapes, grey values,
// names, colours and groups of structures are all.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

/// RT structure sets and segmentations; other kinds of object are an error that names their kind.
Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options);

/// What one file holds, or several of one folder: structures of the first, or where that is an
/// image of CT, MR or PET and the options do something with scans, those of them (scanSurfaces) of
/// each series, called "CT", "MR 2" and so on: names of files and folders may say whose they are.
Result<RawMeshes> readDicomFiles(std::span<const std::filesystem::path> files,
                                 const ReadOptions& options);

/// Images that one scanner made in one go.
struct DicomSeries {
  std::string scanner;  ///< "CT", "MR" or "PET"
  std::vector<std::filesystem::path> files;
};

/// The series of CT, MR and PET among the files, the one of most files first. Files of other kinds
/// and files that cannot be read are left out. Of each no more is read than tells.
std::vector<DicomSeries> seriesIn(std::span<const std::filesystem::path> files,
                                  const ReadOptions& options);

/// The slices of one series of CT, MR or PET (single ones in any order, or the frames of an
/// enhanced image) as one volume, in Hounsfield units where the file says so. The distance of
/// slices is that of their places; slices of a tilted gantry make a slanting grid. Errors: other
/// kinds, slices of several series, sizes or orientations, fewer than two places, several images in
/// one place, distances that differ (nothing is resampled).
Result<GreyVolume> readDicomSeries(std::span<const std::filesystem::path> files,
                                   const ReadOptions& options);

}  // namespace sline::model
