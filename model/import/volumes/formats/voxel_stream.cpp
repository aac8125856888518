// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/voxel_stream.h"

#include <algorithm>
#include <array>
#include <vector>

#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

constexpr std::size_t numbersAtOnce = std::size_t(1) << 16;

Error streamFault(std::string reason, std::string remedy = "Copy or export the file again") {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

/// Returns how many numbers there are, or 0 where that is more than a file of so many bytes may ask
/// for. An empty mask packs a thousandfold, so that the packed bytes alone say little.
std::uint64_t justifiedCount(const VoxelLayout& layout, const VoxelBytes& stored) {
  constexpr std::uint64_t mostVoxels = std::uint64_t(1) << 31;
  const std::uint64_t packed = stored.bytes.size();
  const std::uint64_t voxels = std::min((std::uint64_t(1) << 28) + 256 * packed, mostVoxels);
  std::uint64_t count = 1;
  for (const std::int64_t side : {layout.size.x, layout.size.y, layout.size.z, layout.layers}) {
    if (side < 1 || std::uint64_t(side) > voxels / count)
      return 0;
    count *= std::uint64_t(side);
  }
  const std::uint64_t bytes = count * (stored.text ? 1 : sizeOf(layout.type));
  const bool packs = stored.packing == Packing::deflated || stored.packing == Packing::bzip2;
  const bool small = !packs || bytes <= (std::uint64_t(1) << 29) + 512 * packed;
  return small ? count : 0;
}

Error endsEarly(std::uint64_t count, std::uint64_t found, bool broken) {
  if (broken)
    return streamFault("its packed voxels cannot be unpacked beyond voxel " +
                       std::to_string(found));
  return streamFault("its header promises " + std::to_string(count) +
                     " voxels, the data end after " + std::to_string(found));
}

/// Returns how many unpacked bytes come before the voxels.
Result<std::uint64_t> bytesToSkip(const VoxelLayout& layout, const VoxelBytes& stored,
                                  std::uint64_t count) {
  constexpr std::uint64_t mostSkipped = std::uint64_t(1) << 28;
  const std::uint64_t needed = count * sizeOf(layout.type);
  const char* again = "Export the volume again";
  if (!stored.fromTheEnd && stored.skip > mostSkipped && stored.packing != Packing::none)
    return streamFault("its header asks to pass over " + std::to_string(stored.skip) + " bytes",
                       again);
  if (!stored.fromTheEnd)
    return stored.skip;
  PackedBytes bytes(stored.bytes, stored.packing);
  std::array<char, 16384> piece;
  std::uint64_t all = 0;
  while (const std::size_t got = bytes.read(piece.data(), piece.size())) {
    all += got;
    if (all > needed + mostSkipped)
      return streamFault("it holds far more bytes than its header promises", again);
  }
  if (all < needed)
    return endsEarly(count, all / sizeOf(layout.type), bytes.broken());
  return all - needed;
}

Status binaryRuns(const VoxelLayout& layout, const VoxelBytes& stored, std::uint64_t all,
                  const std::function<bool(const VoxelRun&)>& take) {
  const std::uint64_t skip = TRY(bytesToSkip(layout, stored, all));
  PackedBytes bytes(stored.bytes, stored.packing);
  if (!bytes.skip(skip))
    return endsEarly(all, 0, bytes.broken());
  const std::size_t width = sizeOf(layout.type);
  std::vector<char> piece(numbersAtOnce * width);
  for (std::size_t done = 0; done < all; done += numbersAtOnce) {
    const std::size_t count = std::min<std::size_t>(numbersAtOnce, all - done);
    const std::size_t got = bytes.read(piece.data(), count * width);
    if (got != count * width)
      return endsEarly(all, done + got / width, bytes.broken());
    if (!take({piece.data(), count, done, layout.type, layout.order != std::endian::native}))
      break;
  }
  return Unit{};
}

Status textRuns(const VoxelBytes& stored, std::uint64_t all,
                const std::function<bool(const VoxelRun&)>& take) {
  TextCursor at(stored.bytes);
  std::vector<double> numbers;
  for (std::size_t done = 0; done < all; done += numbers.size()) {
    numbers.resize(std::min<std::size_t>(numbersAtOnce, all - done));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      at.skipSpace();
      if (!at.number(numbers[i]))
        return endsEarly(all, done + i, false);
    }
    if (!take({reinterpret_cast<const char*>(numbers.data()), numbers.size(), done,
               ScalarType::float64, false}))
      break;
  }
  return Unit{};
}

}  // namespace

Result<std::uint64_t> voxelCount(const VoxelLayout& layout, const VoxelBytes& stored) {
  const std::uint64_t count = justifiedCount(layout, stored);
  if (count == 0)
    return streamFault("its header promises " + std::to_string(layout.size.x) + " × " +
                           std::to_string(layout.size.y) + " × " + std::to_string(layout.size.z) +
                           " voxels, more than the file can hold or can be worked on",
                       "Export the volume again, or with larger voxels");
  const std::uint64_t bytes = stored.text ? 2 * count - 1 : count * sizeOf(layout.type);
  if (bytes > mostUnpacked(stored.bytes.size(), stored.packing))
    return streamFault("its header promises " + std::to_string(count) + " voxels, the data hold " +
                       std::to_string(stored.bytes.size()) + " bytes");
  return count;
}

Status forEachRun(const VoxelLayout& layout, const VoxelBytes& stored, std::uint64_t count,
                  const std::function<bool()>& goesOn,
                  const std::function<bool(const VoxelRun&)>& take) {
  bool stopped = false;
  const auto asked = [&](const VoxelRun& run) {
    stopped = !goesOn();
    return !stopped && take(run);
  };
  Status read =
      stored.text ? textRuns(stored, count, asked) : binaryRuns(layout, stored, count, asked);
  if (stopped)
    return streamFault("the import was cancelled", "Import it again");
  return read;
}

bool unpackedBytesHave(const VoxelBytes& stored, std::size_t at, std::string_view magic) {
  PackedBytes bytes(stored.bytes, stored.packing);
  std::vector<char> beginning(at + magic.size());
  return bytes.read(beginning.data(), beginning.size()) == beginning.size() &&
         std::string_view(beginning.data() + at, magic.size()) == magic;
}

}  // namespace sline::model
