// SPDX-License-Identifier: Apache-2.0
// Converts a volume's stored numbers to intensities of 16 bits.
#pragma once

#include <functional>

#include "model/import/volumes/formats/voxel_stream.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

struct DecodedGrey {
  GreyVolume volume;       ///< without name, directions and place
  double roundedBy = 0.0;  ///< greatest rounding of an intensity to 16 bits; 0: all are exact
};

/// Decodes the first layer. Whole numbers that span less than 65,536 are kept as they are; others
/// are rounded to as many even steps between the least and the greatest. A value that is not a
/// number counts as the least. Errors are those of forEachRun, with the file's name.
Result<DecodedGrey> decodeGrey(const VoxelLayout& layout, const VoxelBytes& stored,
                               const std::function<bool()>& goesOn);

}  // namespace sline::model
