// SPDX-License-Identifier: Apache-2.0
// From a volume's stored numbers to the structures its voxels belong to.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <glm/ext/vector_int3_sized.hpp>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/import/readers/packed_bytes.h"
#include "model/import/readers/values.h"
#include "model/import/volumes/label_volume.h"

namespace sline::model {

/// How a header says the numbers lie in the file.
struct VoxelLayout {
  glm::i64vec3 size{0};      ///< as the header has it, not believed yet
  std::int64_t layers = 1;   ///< volumes on the same grid, each with labels of its own
  bool interleaved = false;  ///< a voxel's layers lie side by side
  ScalarType type = ScalarType::uint8;
  std::endian order = std::endian::little;
  double slope = 1.0;  ///< the label is slope × number + intercept
  double intercept = 0.0;
};

/// Where the numbers are. `bytes` reach to the end of the file.
struct VoxelBytes {
  std::string file;  ///< as the user gave it
  std::string_view bytes;
  Packing packing = Packing::none;
  bool text = false;        ///< numbers in decimal, parted by white space; not packed
  std::uint64_t skip = 0;   ///< bytes to pass over when unpacked
  bool fromTheEnd = false;  ///< rather the last bytes of what is unpacked
};

/// One volume per layer, without names, directions or place; a label's name is empty. Voxels whose
/// value is not a number count as background, and so does one negative value. Refused: more voxels
/// than the bytes can hold or a machine should, data that end early or cannot be unpacked, and
/// values that are an image's rather than labels.
Result<std::vector<LabelVolume>> decodeVoxels(const VoxelLayout& layout, const VoxelBytes& stored,
                                              const std::function<bool()>& goesOn);

/// True where the unpacked bytes have `magic` at byte `at`.
bool unpackedBytesHave(const VoxelBytes& stored, std::size_t at, std::string_view magic);

}  // namespace sline::model
