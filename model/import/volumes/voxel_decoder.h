// SPDX-License-Identifier: Apache-2.0
// From a volume's stored numbers to the structures its voxels belong to.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"
#include "model/import/volumes/formats/voxel_stream.h"

namespace sline::model {

struct DecodedLabels {
  std::vector<LabelVolume> volumes;  ///< one per layer
  std::string image;  ///< what shows that its values are an image's; there are no volumes then
};

/// The volumes have neither names, directions nor place; a label's name is empty. Voxels whose
/// value is not a number count as background, and so does one negative value. Errors are those of
/// forEachRun, with the file's name.
Result<DecodedLabels> decodeLabels(const VoxelLayout& layout, const VoxelBytes& stored,
                                   const std::function<bool()>& goesOn);

}  // namespace sline::model
