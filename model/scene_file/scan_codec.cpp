// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/scan_codec.h"

#include <cstring>

#include "model/base/number_codes.h"

namespace sline::model {

namespace {
constexpr std::string_view scanMagic = "SlineSc1";
}  // namespace

std::string encodedVoxels(const std::vector<std::int16_t>& voxels) {
  const std::size_t count = voxels.size();
  std::string bytes(scanMagic.size() + 2 * count, '\0');
  std::memcpy(bytes.data(), scanMagic.data(), scanMagic.size());
  char* low = bytes.data() + scanMagic.size();
  char* high = low + count;
  std::uint16_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = std::uint16_t(voxels[i]);
    const std::uint16_t code = zigzag(std::uint16_t(value - last));
    low[i] = char(code & 0xffu);
    high[i] = char(code >> 8);
    last = value;
  }
  return bytes;
}

Result<std::vector<std::int16_t>> decodedVoxels(std::string_view bytes) {
  if (!bytes.starts_with(scanMagic))
    return Error{.reason = "it does not begin like the voxels of a scan"};
  bytes.remove_prefix(scanMagic.size());
  if (bytes.size() % 2 != 0)
    return Error{.reason = "it ends amid a voxel"};
  const std::size_t count = bytes.size() / 2;
  std::vector<std::int16_t> voxels(count);
  std::uint16_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto low = static_cast<unsigned char>(bytes[i]);
    const auto high = static_cast<unsigned char>(bytes[count + i]);
    last = std::uint16_t(last + unzigzag(std::uint16_t(low | high << 8)));
    voxels[i] = std::int16_t(last);
  }
  return voxels;
}

}  // namespace sline::model
