// SPDX-License-Identifier: Apache-2.0
// Converts a volume's stored numbers to the structures that its voxels belong to.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"
#include "model/import/volumes/formats/voxel_stream.h"

namespace sline::model {

struct DecodedLabels {
  std::vector<LabelVolume> volumes;  ///< one per layer
  std::string image;                 ///< evidence that the values are an image's; no volumes then
};

/// Decodes the volumes, which have neither names, directions nor place; a label's name is empty.
/// Voxels with a value that is not a number count as background, and so does one negative value.
/// Errors are those of forEachRun, with the file's name.
Result<DecodedLabels> decodeLabels(const VoxelLayout& layout, const VoxelBytes& stored,
                                   const std::function<bool()>& goesOn);

}  // namespace sline::model
