// SPDX-License-Identifier: Apache-2.0
// Reads FreeSurfer's MGH (surfer.nmr.mgh.harvard.edu, "MghFormat"): big-endian numbers, voxels at
// byte 284, and behind them tags, one of which holds a colour table.
#include <algorithm>
#include <array>
#include <bit>

#include "model/import/source/packed_bytes.h"
#include "model/import/source/source.h"
#include "model/import/volumes/formats/free_surfer_labels.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

namespace {

constexpr std::size_t mghVoxels = 284;
constexpr std::size_t mghSizes = 4;  // width, height, depth, frames
constexpr std::size_t mghType = 20;
constexpr std::size_t mghPlaceKnown = 28;  // a short; the numbers from 30 on count if it is not 0
constexpr std::size_t mghSpacings = 30;
constexpr std::size_t mghDirections = 42;
constexpr std::size_t mghCentre = 78;

std::optional<ScalarType> mghTypeOf(std::int32_t code) {
  switch (code) {
    case 0:
      return ScalarType::uint8;
    case 1:
      return ScalarType::int32;
    case 3:
      return ScalarType::float32;
    case 4:
      return ScalarType::int16;
    case 10:
      return ScalarType::uint16;
    default:
      return std::nullopt;
  }
}

/// Reads the data behind the voxels: a few numbers of the scan, then tags with their lengths.
class MghFooter {
 public:
  explicit MghFooter(std::string_view text)
      : m_values(text.data(), text.data() + text.size(), std::endian::big) {}

  LabelNames labels() {
    // These are repetition time, flip angle, echo time, inversion time, field of view.
    if (!m_values.skip(ScalarType::float32, 5))
      return {};
    constexpr std::int64_t table = 1;
    while (const std::optional<std::int64_t> tag = whole()) {
      if (*tag == table)
        return readTable();
      if (*tag == 0 || !skipTag(*tag))
        break;
    }
    return {};
  }

 private:
  std::optional<std::int64_t> whole(ScalarType type = ScalarType::int32) {
    std::int64_t value = 0;
    return m_values.integer(type, value) ? std::optional(value) : std::nullopt;
  }

  /// Skips a tag; old tags have no length or one of four bytes, the others one of eight.
  bool skipTag(std::int64_t tag) {
    constexpr std::int64_t realRas = 2;
    constexpr std::int64_t surfaceGeometry = 20;
    constexpr std::int64_t oldTransform = 30;
    if (tag == realRas || tag == surfaceGeometry)
      return false;
    std::optional<std::int64_t> length =
        whole(tag == oldTransform ? ScalarType::int32 : ScalarType::int64);
    if (length && tag == oldTransform)
      --*length;
    return length && *length >= 0 && m_values.skip(ScalarType::uint8, std::uint64_t(*length));
  }

  std::optional<std::string> text() {
    constexpr std::int64_t longest = 65'536;
    const std::optional<std::int64_t> length = whole();
    const char* begin = m_values.at();
    if (!length || *length < 0 || *length > longest ||
        !m_values.skip(ScalarType::uint8, std::uint64_t(*length)))
      return std::nullopt;
    const std::string_view all(begin, std::size_t(*length));
    return std::string(all.substr(0, all.find('\0')));
  }

  /// Reads entries by number, or (a negative version first) as many as the table says, each with
  /// its number.
  LabelNames readTable() {
    LabelNames names;
    const std::optional<std::int64_t> first = whole();
    const bool numbered = first && *first < 0;
    if (!first || (numbered && !whole()) || !text())
      return names;
    const std::optional<std::int64_t> count = numbered ? whole() : first;
    for (std::int64_t i = 0; count && i < *count; ++i) {
      const std::optional<std::int64_t> value = numbered ? whole() : std::optional(i);
      const std::optional<std::string> name = value ? text() : std::nullopt;
      std::array<std::uint8_t, 4> channels{};
      for (std::uint8_t& channel : channels) {
        const std::optional<std::int64_t> byte = name ? whole() : std::nullopt;
        if (!byte)
          return names;
        channel = std::uint8_t(std::clamp<std::int64_t>(*byte, 0, 255));
      }
      if (!name->empty())
        names.emplace(*value,
                      Label{*value, *name, Colour{channels[0], channels[1], channels[2]}, {}});
    }
    return names;
  }

  BinaryValues m_values;
};

class MghReader {
 public:
  MghReader(const Source& source, const ReadOptions& options)
      : m_source(source), m_options(options) {}

  Result<VolumeFile> read() {
    m_file.stored.file = m_source.file();
    m_file.stored.bytes = m_source.text();
    m_file.stored.packing = beginsLikeGzip(m_source.text()) ? Packing::deflated : Packing::none;
    m_file.stored.skip = mghVoxels;
    PackedBytes bytes(m_file.stored.bytes, m_file.stored.packing);
    if (bytes.read(m_header.data(), m_header.size()) != m_header.size() ||
        number<std::int32_t>(0) != 1)
      return m_source.atByte(m_source.begin(), "does not begin like a volume of FreeSurfer (MGH)",
                             "Export it as .mgz again, or give the file the extension of its kind");
    TRY(readLayout());
    readPlace();
    m_file.names = [layout = m_file.layout, stored = m_file.stored, limits = m_options.limits](
                       const LabelVolume& volume, std::size_t) {
      const std::string footer = behindVoxels(layout, stored);
      LabelNames names = MghFooter(footer).labels();
      std::string from;
      if (names.empty())
        names = labelsBeside(stored.file, limits, from);
      return names.empty() ? freeSurferLabels(volume, stored.file) : names;
    };
    return std::move(m_file);
  }

 private:
  template <class T>
  T number(std::size_t at) const {
    return loadAs<T>(m_header.data() + at, std::endian::native != std::endian::big);
  }
  glm::dvec3 three(std::size_t at) const {
    return {double(number<float>(at)), double(number<float>(at + 4)),
            double(number<float>(at + 8))};
  }

  Status readLayout() {
    for (int i = 0; i < 3; ++i)
      m_file.layout.size[i] = number<std::int32_t>(mghSizes + 4 * std::size_t(i));
    m_file.layout.layers = number<std::int32_t>(mghSizes + 12);
    const std::int32_t code = number<std::int32_t>(mghType);
    const std::optional<ScalarType> type = mghTypeOf(code);
    if (!type)
      return m_source.whole(
          "its voxels are of type " + std::to_string(code) + ", which is none of labels",
          "Export it with whole numbers");
    m_file.layout.type = *type;
    m_file.layout.order = std::endian::big;
    return Unit{};
  }

  /// Reads the centre, from which the first voxel's place follows.
  void readPlace() {
    glm::dmat4 toRas(1.0);
    const glm::dvec3 spacing = three(mghSpacings);
    for (int i = 0; i < 3; ++i)
      toRas[i] = glm::dvec4(three(mghDirections + 12 * std::size_t(i)) * spacing[i], 0.0);
    const glm::dvec3 middle = 0.5 * glm::dvec3(m_file.layout.size);
    m_file.unitReason = "FreeSurfer is in millimetres";
    if (number<std::int16_t>(mghPlaceKnown) > 0) {
      toRas[3] = glm::dvec4(three(mghCentre) - glm::dvec3(toRas * glm::dvec4(middle, 0.0)), 1.0);
      for (int column = 0; column < 4; ++column)
        m_file.toLps[column] = toRas[column] * glm::dvec4(-1.0, -1.0, 1.0, 1.0);
      m_file.frame = Frame::ras;
      m_file.frameReason = "directions of the voxels (FreeSurfer is RAS)";
      return;
    }
    // FreeSurfer takes such a volume for coronal slices from behind to the front, upside down.
    m_file.toLps = glm::dmat4(1.0);
    m_file.toLps[1] = {0.0, 0.0, -1.0, 0.0};
    m_file.toLps[2] = {0.0, 1.0, 0.0, 0.0};
    m_file.toLps[3] = glm::dvec4(-glm::dvec3(m_file.toLps * glm::dvec4(middle, 0.0)), 1.0);
    m_file.onlySideOpen = true;
    m_file.warnings.push_back(m_source.warning(
        "says nothing of where its voxels lie: it is taken as FreeSurfer's usual coronal slices, "
        "and which side is left from names, if they tell"));
  }

  static std::string behindVoxels(const VoxelLayout& layout, const VoxelBytes& stored) {
    constexpr std::size_t longest = std::size_t(8) << 20;
    PackedBytes bytes(stored.bytes, stored.packing);
    const glm::i64vec3& size = layout.size;
    const auto count = std::uint64_t(size.x * size.y * size.z * layout.layers);
    std::string text;
    if (!bytes.skip(mghVoxels + count * sizeOf(layout.type)))
      return text;
    constexpr std::size_t piece = 65'536;
    for (std::size_t got = piece; got == piece && text.size() < longest;) {
      const std::size_t before = text.size();
      text.resize(before + piece);
      got = bytes.read(text.data() + before, piece);
      text.resize(before + got);
    }
    return text;
  }

  const Source& m_source;
  const ReadOptions& m_options;
  std::array<char, mghVoxels> m_header{};
  VolumeFile m_file;
};

}  // namespace

Result<VolumeFile> openMgh(const std::filesystem::path& file, const ReadOptions& options) {
  Source source = TRY(Source::readStored(file, options.limits));
  const auto kept = std::make_shared<const Source>(std::move(source));
  Result<VolumeFile> volume = MghReader(*kept, options).read();
  if (volume)
    volume->sources.push_back(kept);
  return volume;
}

}  // namespace sline::model
