// SPDX-License-Identifier: Apache-2.0
// Reads a volume file of any format into the label volumes in it, each layer of overlapping
// segments one, with names and colours from the header or a table beside the file; or into the scan
// that it is. Data in a file of their own are read only from the header's folder. Errors and memory
// are as readers/readers.h promises; voxels are refused where the file's bytes do not justify them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

struct GreyVolumeRead {
  std::shared_ptr<const GreyVolume> volume;
  std::vector<ImportWarning> warnings;
  std::vector<std::string> notes;  ///< how its numbers were interpreted
};

/// Holds either labels or a scan.
struct VolumeRead {
  LabelVolumes labels;
  GreyVolumeRead scan;
};

/// Reads the file and tells labels from intensities by the values. A scan is an error that says
/// what can be done with it, unless the options have something to do with it: a threshold, or that
/// scans are kept.
Result<VolumeRead> readVolume(const std::filesystem::path& file, const ReadOptions& options);

/// Reads intensities, whatever the values look like. Files of these formats do not say whether they
/// hold Hounsfield units; they are taken to where something is as dark as air and something as
/// dense as contrast or bone. Of several images at one place the first is read, with a warning.
Result<GreyVolumeRead> readGreyVolume(const std::filesystem::path& file,
                                      const ReadOptions& options);

}  // namespace sline::model
