// SPDX-License-Identifier: Apache-2.0
// The door to DICOM: it finds out which objects hold segmentations, makes surfaces of them and
// makes volumes of scanners' slices. No patient data gets through it: only shapes, grey values,
// names, colours and groups of structures do.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

/// Reads RT structure sets and segmentations; other kinds of object are an error that names their
/// kind.
Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options);

/// Reads one file, or several of one folder. Returns the structures of the first file, or, where
/// that is an image of CT, MR or PET and the options do something with scans, those of the scans
/// (scanSurfaces) of each series. Scans are called "CT", "MR 2" and so on, because the names of
/// files and folders may reveal the patient.
Result<RawMeshes> readDicomFiles(std::span<const std::filesystem::path> files,
                                 const ReadOptions& options);

/// Holds the files of images that one scanner made in one go.
struct DicomSeries {
  std::string scanner;  ///< "CT", "MR" or "PET"
  std::vector<std::filesystem::path> files;
};

/// Returns the series of CT, MR and PET among the files, the one with the most files first. Files
/// of other kinds and files that cannot be read are left out. Of each file no more is read than is
/// needed to tell.
std::vector<DicomSeries> seriesIn(std::span<const std::filesystem::path> files,
                                  const ReadOptions& options);

/// Reads the slices of one series of CT, MR or PET (single ones in any order, or the frames of an
/// enhanced image) as one volume, in Hounsfield units where the file says so. The distance between
/// slices is that of their places; slices of a tilted gantry make a slanting grid. Errors: other
/// kinds, slices of several series, sizes or orientations, fewer than two places, several images in
/// one place, distances that differ (nothing is resampled).
Result<GreyVolume> readDicomSeries(std::span<const std::filesystem::path> files,
                                   const ReadOptions& options);

}  // namespace sline::model
