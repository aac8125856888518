// SPDX-License-Identifier: Apache-2.0
// A volume file of any format → the label volumes in it, each layer of overlapping segments one,
// with names and colours from the header or a table beside the file; or the scan that it is. Data
// in a file of their own are read only from the header's folder. What readers promise of errors and
// memory is what readers/readers.h says; voxels are refused where the file's bytes do not justify
// them.
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
  std::vector<std::string> notes;  ///< what its numbers were taken to be
};

/// One of both.
struct VolumeRead {
  LabelVolumes labels;
  GreyVolumeRead scan;
};

/// Tells labels from intensities by the values. A scan is an error that says what can be done with
/// it, unless the options have something to do with it: a threshold, or that scans are kept.
Result<VolumeRead> readVolume(const std::filesystem::path& file, const ReadOptions& options);

/// Intensities, whatever the values look like. Files of these formats do not say whether they hold
/// Hounsfield units; they do where something is as dark as air and something as dense as contrast
/// or bone. Of several images at one place the first is read, with a warning.
Result<GreyVolumeRead> readGreyVolume(const std::filesystem::path& file,
                                      const ReadOptions& options);

}  // namespace sline::model
