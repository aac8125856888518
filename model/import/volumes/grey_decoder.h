// SPDX-License-Identifier: Apache-2.0
// From a volume's stored numbers to intensities of 16 bits.
#pragma once

#include <functional>

#include "model/import/volumes/formats/voxel_stream.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

struct DecodedGrey {
  GreyVolume volume;  ///< without name, directions and place
  double roundedBy =
      0.0;  ///< the most by which 16 bits put an intensity off; 0: every one is exact
};

/// The first layer. Whole numbers that span less than 65,536 are kept as they are; others are
/// rounded to as many even steps between the least and the greatest. What is not a number counts as
/// the least. Errors are those of forEachRun, with the file's name.
Result<DecodedGrey> decodeGrey(const VoxelLayout& layout, const VoxelBytes& stored,
                               const std::function<bool()>& goesOn);

}  // namespace sline::model
