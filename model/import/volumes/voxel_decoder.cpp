// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/voxel_decoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "model/import/readers/text_cursor.h"
#include "model/import/volumes/label_codes.h"

namespace sline::model {

namespace {

constexpr const char* noLabels =
    "Choose the segmentation that was made of the image, not the image itself";

Error fault(std::string reason, std::string remedy = "Export the volume again") {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

/// How many numbers there are, or 0 where that is more than a file of so many bytes may ask for. An
/// empty mask packs a thousandfold, so that the packed bytes alone say little.
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

class Decoder {
 public:
  Decoder(const VoxelLayout& layout, const VoxelBytes& stored, const std::function<bool()>& goesOn)
      : m_layout(layout),
        m_stored(stored),
        m_goesOn(goesOn),
        m_layers(std::size_t(layout.layers)),
        m_perLayer(std::size_t(layout.size.x * layout.size.y * layout.size.z)),
        m_count(m_layers * m_perLayer),
        m_codes(m_layers),
        m_volumes(m_layers) {}

  Result<std::vector<LabelVolume>> run() {
    for (LabelVolume& volume : m_volumes) {
      volume.size = glm::ivec3(m_layout.size);
      volume.voxels.resize(m_perLayer);
    }
    if (const Status read = m_stored.text ? readText() : readBinary(); !read)
      return read.error();
    for (std::size_t i = 0; i < m_layers; ++i) {
      std::vector<std::uint16_t>& voxels = m_volumes[i].voxels;
      const auto empty = std::size_t(std::count(voxels.begin(), voxels.end(), 0));
      if (std::string reason = m_codes[i].refusal(voxels.size() - empty); !reason.empty())
        return fault("is an image rather than a label volume: " + reason, noLabels);
      m_volumes[i].labels = m_codes[i].sorted(voxels);
    }
    return std::move(m_volumes);
  }

 private:
  Error endsEarly(const PackedBytes* bytes, std::uint64_t found) const {
    if (bytes && bytes->broken())
      return fault("its packed voxels cannot be unpacked beyond voxel " + std::to_string(found),
                   "Copy or export the file again");
    return fault("its header promises " + std::to_string(m_count) + " voxels, the data end after " +
                     std::to_string(found),
                 "Copy or export the file again");
  }

  Status readBinary() {
    PackedBytes bytes(m_stored.bytes, m_stored.packing);
    const std::size_t width = sizeOf(m_layout.type);
    const Result<std::uint64_t> skip = toSkip(m_count * width);
    if (!skip)
      return skip.error();
    if (!bytes.skip(*skip))
      return endsEarly(&bytes, 0);
    constexpr std::size_t atATime = std::size_t(1) << 16;
    std::vector<char> piece(atATime * width);
    for (std::size_t done = 0; done < m_count; done += atATime) {
      const std::size_t count = std::min(atATime, m_count - done);
      const std::size_t got = bytes.read(piece.data(), count * width);
      if (got != count * width)
        return endsEarly(&bytes, done + got / width);
      if (!m_goesOn())
        return fault("the import was cancelled");
      takeAs(piece.data(), count, done);
      if (refused())
        break;
    }
    return Unit{};
  }

  /// How many unpacked bytes come before the voxels.
  Result<std::uint64_t> toSkip(std::uint64_t needed) const {
    constexpr std::uint64_t mostSkipped = std::uint64_t(1) << 28;
    if (!m_stored.fromTheEnd && m_stored.skip > mostSkipped && m_stored.packing != Packing::none)
      return fault("its header asks to pass over " + std::to_string(m_stored.skip) + " bytes");
    if (!m_stored.fromTheEnd)
      return m_stored.skip;
    PackedBytes bytes(m_stored.bytes, m_stored.packing);
    std::array<char, 16384> piece;
    std::uint64_t all = 0;
    while (const std::size_t got = bytes.read(piece.data(), piece.size())) {
      all += got;
      if (all > needed + mostSkipped)
        return fault("it holds far more bytes than its header promises");
    }
    if (all < needed)
      return endsEarly(&bytes, all / sizeOf(m_layout.type));
    return all - needed;
  }

  void takeAs(const char* at, std::size_t count, std::size_t first) {
    switch (m_layout.type) {
      case ScalarType::int8:
        return take<std::int8_t>(at, count, first);
      case ScalarType::uint8:
        return take<std::uint8_t>(at, count, first);
      case ScalarType::int16:
        return take<std::int16_t>(at, count, first);
      case ScalarType::uint16:
        return take<std::uint16_t>(at, count, first);
      case ScalarType::int32:
        return take<std::int32_t>(at, count, first);
      case ScalarType::uint32:
        return take<std::uint32_t>(at, count, first);
      case ScalarType::int64:
        return take<std::int64_t>(at, count, first);
      case ScalarType::uint64:
        return take<std::uint64_t>(at, count, first);
      case ScalarType::float32:
        return take<float>(at, count, first);
      case ScalarType::float64:
        return take<double>(at, count, first);
    }
  }

  /// A label that is off a whole number by what its scale was rounded by is that number.
  double scaledLabel(double stored) const {
    const double value = m_layout.slope * stored + m_layout.intercept;
    const double whole = std::round(value);
    return std::abs(value - whole) <= 1e-6 * std::max(1.0, std::abs(whole)) ? whole : value;
  }

  template <class T>
  void take(const char* at, std::size_t count, std::size_t first) {
    const bool swap = m_layout.order != std::endian::native;
    const bool scaled = m_layout.slope != 1.0 || m_layout.intercept != 0.0;
    if (m_layers == 1 && !scaled) {
      takeRun<T>(at, count, first, swap);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const T value = loadAs<T>(at + i * sizeof(T), swap);
      if (scaled)
        put(first + i, scaledLabel(double(value)));
      else
        put(first + i, value);
    }
  }

  /// Of one layer: most voxels are what the one before is.
  template <class T>
  void takeRun(const char* at, std::size_t count, std::size_t first, bool swap) {
    std::uint16_t* to = m_volumes[0].voxels.data() + first;
    T last = loadAs<T>(at, swap);
    std::uint16_t code = m_codes[0](last);
    for (std::size_t i = 0; i < count; ++i) {
      const T value = loadAs<T>(at + i * sizeof(T), swap);
      if (value != last) {
        code = m_codes[0](value);
        last = value;
      }
      to[i] = code;
    }
  }

  template <class T>
  void put(std::size_t index, T value) {
    const std::size_t layer = m_layout.interleaved ? index % m_layers : index / m_perLayer;
    const std::size_t voxel = m_layout.interleaved ? index / m_layers : index % m_perLayer;
    m_volumes[layer].voxels[voxel] = m_codes[layer](value);
  }

  Status readText() {
    TextCursor at(m_stored.bytes);
    for (std::size_t i = 0; i < m_count; ++i) {
      at.skipSpace();
      double value = 0.0;
      if (!at.number(value))
        return endsEarly(nullptr, i);
      put(i, scaledLabel(value));
      if (i % 65536 == 0 && (!m_goesOn() || refused()))
        break;
    }
    return Unit{};
  }

  bool refused() const {
    return std::any_of(m_codes.begin(), m_codes.end(),
                       [](const LabelCodes& codes) { return codes.refused(); });
  }

  const VoxelLayout& m_layout;
  const VoxelBytes& m_stored;
  const std::function<bool()>& m_goesOn;
  std::size_t m_layers;
  std::size_t m_perLayer;
  std::size_t m_count;
  std::vector<LabelCodes> m_codes;
  std::vector<LabelVolume> m_volumes;
};

Result<std::vector<LabelVolume>> decoded(const VoxelLayout& layout, const VoxelBytes& stored,
                                         const std::function<bool()>& goesOn) {
  constexpr std::int64_t mostLayers = 512;
  if (layout.layers > mostLayers)
    return fault("holds " + std::to_string(layout.layers) + " volumes in one, at most " +
                     std::to_string(mostLayers) + " are read",
                 "Export one label volume");
  const std::uint64_t count = justifiedCount(layout, stored);
  if (count == 0)
    return fault("its header promises " + std::to_string(layout.size.x) + " × " +
                     std::to_string(layout.size.y) + " × " + std::to_string(layout.size.z) +
                     " voxels, more than the file can hold or can be worked on",
                 "Export the volume again, or with larger voxels");
  const std::uint64_t bytes = stored.text ? 2 * count - 1 : count * sizeOf(layout.type);
  if (bytes > mostUnpacked(stored.bytes.size(), stored.packing))
    return fault("its header promises " + std::to_string(count) + " voxels, the data hold " +
                     std::to_string(stored.bytes.size()) + " bytes",
                 "Copy or export the file again");
  try {
    return Decoder(layout, stored, goesOn).run();
  } catch (const std::bad_alloc&) {
    return fault("needs more memory than there is", "Close other programs");
  }
}

}  // namespace

Result<std::vector<LabelVolume>> decodeVoxels(const VoxelLayout& layout, const VoxelBytes& stored,
                                              const std::function<bool()>& goesOn) {
  Result<std::vector<LabelVolume>> volumes = decoded(layout, stored, goesOn);
  if (volumes)
    return volumes;
  Error error = volumes.error();
  error.file = stored.file;
  return error;
}

bool unpackedBytesHave(const VoxelBytes& stored, std::size_t at, std::string_view magic) {
  PackedBytes bytes(stored.bytes, stored.packing);
  std::vector<char> beginning(at + magic.size());
  return bytes.read(beginning.data(), beginning.size()) == beginning.size() &&
         std::string_view(beginning.data() + at, magic.size()) == magic;
}

}  // namespace sline::model
