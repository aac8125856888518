// SPDX-License-Identifier: Apache-2.0
// Reads a volume's stored numbers, run by run: unpacked, in their own type, never more of them than
// the file's bytes justify.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <glm/ext/vector_int3_sized.hpp>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/values.h"

namespace sline::model {

/// Describes how a header says the numbers lie in the file.
struct VoxelLayout {
  glm::i64vec3 size{0};      ///< as the header has it, not yet verified
  std::int64_t layers = 1;   ///< volumes on the same grid
  bool interleaved = false;  ///< a voxel's layers lie side by side
  ScalarType type = ScalarType::uint8;
  std::endian order = std::endian::little;
  double slope = 1.0;  ///< a value is slope × number + intercept
  double intercept = 0.0;

  bool scaled() const { return slope != 1.0 || intercept != 0.0; }
};

/// Says where the numbers are. `bytes` reach to the end of the file.
struct VoxelBytes {
  std::string file;  ///< as the user gave it
  std::string_view bytes;
  Packing packing = Packing::none;
  bool text = false;        ///< decimal numbers, separated by white space; not packed
  std::uint64_t skip = 0;   ///< bytes to pass over after unpacking
  bool fromTheEnd = false;  ///< the values are the last bytes after unpacking instead
};

/// Holds some numbers one after another.
struct VoxelRun {
  const char* at;
  std::size_t count;
  std::size_t first;  ///< index of the first among all
  ScalarType type;    ///< that of the layout; float64 where they stood as text
  bool swap;          ///< their bytes stand in reverse order
};

/// Returns how many numbers there are; refuses more than the bytes or the machine can hold.
Result<std::uint64_t> voxelCount(const VoxelLayout& layout, const VoxelBytes& stored);

/// Hands the first `count` numbers on until `take` says no. Errors, which name no file: data that
/// ends early or cannot be unpacked, and `goesOn` having said no.
Status forEachRun(const VoxelLayout& layout, const VoxelBytes& stored, std::uint64_t count,
                  const std::function<bool()>& goesOn,
                  const std::function<bool(const VoxelRun&)>& take);

/// Calls visit(T()) with the C++ type that `type` names.
template <class Visit>
void withNumberType(ScalarType type, const Visit& visit) {
  switch (type) {
    // NOLINTNEXTLINE(bugprone-branch-clone): each has another type
    case ScalarType::int8:
      return visit(std::int8_t());
    case ScalarType::uint8:
      return visit(std::uint8_t());
    case ScalarType::int16:
      return visit(std::int16_t());
    case ScalarType::uint16:
      return visit(std::uint16_t());
    case ScalarType::int32:
      return visit(std::int32_t());
    case ScalarType::uint32:
      return visit(std::uint32_t());
    case ScalarType::int64:
      return visit(std::int64_t());
    case ScalarType::uint64:
      return visit(std::uint64_t());
    case ScalarType::float32:
      return visit(float());
    case ScalarType::float64:
      return visit(double());
  }
}

/// Returns true where the unpacked bytes have `magic` at byte `at`.
bool unpackedBytesHave(const VoxelBytes& stored, std::size_t at, std::string_view magic);

}  // namespace sline::model
