// SPDX-License-Identifier: Apache-2.0
// Reads MetaImage (ITK's MetaIO, "MetaImage format"): lines of "Key = value", the last of which
// says where the voxels are.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/base/letters.h"
#include "model/import/source/file_in_folder.h"
#include "model/import/source/text_cursor.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

namespace {

std::optional<ScalarType> metaType(std::string_view name) {
  static constexpr std::pair<std::string_view, ScalarType> rows[] = {
      {"met_char", ScalarType::int8},       {"met_uchar", ScalarType::uint8},
      {"met_short", ScalarType::int16},     {"met_ushort", ScalarType::uint16},
      {"met_int", ScalarType::int32},       {"met_uint", ScalarType::uint32},
      {"met_long", ScalarType::int32},      {"met_ulong", ScalarType::uint32},
      {"met_long_long", ScalarType::int64}, {"met_ulong_long", ScalarType::uint64},
      {"met_float", ScalarType::float32},   {"met_double", ScalarType::float64}};
  for (const auto& [known, type] : rows)
    if (equalsIgnoringCase(name, known))
      return type;
  return std::nullopt;
}

/// Returns the directions of the axes in LPS, from letters that say where each begins: "RAI" runs
/// from right to left, from anterior to posterior and from inferior to superior, as LPS does.
std::optional<std::array<glm::dvec3, 3>> axesFrom(std::string_view letters) {
  std::array<glm::dvec3, 3> axes;
  unsigned seen = 0;
  if (letters.size() != 3)
    return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr std::string_view known = "RLAPIS";
    const std::size_t at = known.find(letters[i]);
    if (at == std::string_view::npos)
      return std::nullopt;
    seen |= 1u << at / 2;
    axes[i] = glm::dvec3(0.0);
    axes[i][int(at / 2)] = at % 2 == 0 ? 1.0 : -1.0;
  }
  return seen == 7 ? std::optional(axes) : std::nullopt;
}

class MetaImageReader {
 public:
  MetaImageReader(const Source& source, const ReadOptions& options)
      : m_source(source), m_options(options) {}

  Result<VolumeFile> read() {
    TRY(readLines());
    TRY(readLayout());
    TRY(readPlace());
    TRY(findData());
    m_file.unitReason = "MetaImage is in millimetres";
    m_file.names = [file = m_source.file(), limits = m_options.limits](const LabelVolume&,
                                                                       std::size_t) {
      std::string from;
      return labelsBeside(file, limits, from);
    };
    return std::move(m_file);
  }

 private:
  Status readLines() {
    constexpr std::size_t mostLines = 10'000;
    TextCursor at(m_source.text());
    for (std::size_t line = 0; line < mostLines && !at.atEnd(); ++line) {
      const char* begin = at.at();
      const std::string_view text = at.restOfLine();
      const std::size_t equals = text.find('=');
      if (text.empty())
        continue;
      if (equals == std::string_view::npos || text.size() > 65'536)
        return m_source.atLine(begin, "is no line of a MetaImage header: " + inQuotes(text));
      std::string_view key = text.substr(0, equals);
      while (!key.empty() && TextCursor::isSpace(key.back()))
        key.remove_suffix(1);
      TextCursor value(text.substr(equals + 1));
      value.skipSpace();
      m_lines[std::string(key)] = {value.at(), std::size_t(value.end() - value.at())};
      if (key == "ElementDataFile") {
        m_behind = {at.at(), std::size_t(at.end() - at.at())};
        return Unit{};
      }
    }
    return m_source.whole("has no line ElementDataFile, as a MetaImage ends its header with");
  }

  std::string_view value(std::string_view key) const {
    const auto found = m_lines.find(key);
    return found == m_lines.end() ? std::string_view() : found->second;
  }
  bool isTrue(std::string_view key) const { return equalsIgnoringCase(value(key), "true"); }

  /// Reads the numbers behind a key; returns false where there are not so many.
  bool numbers(std::string_view key, std::span<double> to) const {
    TextCursor at(value(key));
    for (double& number : to) {
      at.skipSpace();
      if (!at.number(number) || !std::isfinite(number))
        return false;
    }
    return true;
  }

  Status readLayout() {
    std::int64_t axes = 0;
    TextCursor(value("NDims")).integer(axes);
    if (axes != 3)
      return m_source.at("NDims", "has " + std::to_string(axes) + " axes, a volume needs three",
                         "Export a volume with three axes in space");
    TextCursor at(value("DimSize"));
    for (int i = 0; i < 3; ++i) {
      at.skipSpace();
      std::int64_t size = 0;
      if (!at.integer(size) || size < 1)
        return m_source.at("DimSize", "is no list of sizes: " + inQuotes(value("DimSize")));
      m_file.layout.size[i] = size;
    }
    std::int64_t channels = 1;
    TextCursor(value("ElementNumberOfChannels")).integer(channels);
    const std::string_view name = value("ElementType");
    const std::optional<ScalarType> type = metaType(name);
    if (!type || channels != 1)
      return m_source.at("ElementType",
                         "its voxels are " + inQuotes(name) + " × " + std::to_string(channels) +
                             ", which is neither of labels nor of intensities",
                         "Export it with one number per voxel");
    m_file.layout.type = *type;
    const bool big = isTrue("BinaryDataByteOrderMSB") || isTrue("ElementByteOrderMSB");
    m_file.layout.order = big ? std::endian::big : std::endian::little;
    return Unit{};
  }

  Status readPlace() {
    std::array<double, 3> spacing{1.0, 1.0, 1.0};
    std::array<double, 3> origin{};
    std::array<double, 9> axes{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    if (!numbers("ElementSpacing", spacing) && !numbers("ElementSize", spacing))
      spacing = {1.0, 1.0, 1.0};
    for (const char* key : {"Offset", "Position", "Origin"})
      if (!value(key).empty() && !numbers(key, origin))
        return m_source.at(key, "is no place: " + inQuotes(value(key)));
    bool given = false;
    for (const char* key : {"TransformMatrix", "Rotation", "Orientation"}) {
      if (value(key).empty())
        continue;
      given = true;
      if (!numbers(key, axes))
        return m_source.at(key, "is no matrix of nine numbers: " + inQuotes(value(key)));
    }
    m_file.frame = Frame::lps;
    m_file.frameReason = given ? "TransformMatrix (MetaImage is LPS)" : "MetaImage is LPS";
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = 3 * i;
      m_file.toLps[int(i)] =
          glm::dvec4(glm::dvec3(axes[k], axes[k + 1], axes[k + 2]) * spacing[i], 0.0);
    }
    const std::string_view letters = value("AnatomicalOrientation");
    if (const auto found = axesFrom(letters); found && !given) {
      for (int i = 0; i < 3; ++i)
        m_file.toLps[i] = glm::dvec4((*found)[std::size_t(i)] * spacing[std::size_t(i)], 0.0);
      m_file.frameReason = "AnatomicalOrientation " + std::string(letters);
    }
    m_file.toLps[3] = glm::dvec4(origin[0], origin[1], origin[2], 1.0);
    return Unit{};
  }

  Status findData() {
    if (isTrue("CompressedData"))
      m_file.stored.packing = Packing::deflated;
    else
      m_file.stored.text = equalsIgnoringCase(value("BinaryData"), "false");
    const std::string_view name = value("ElementDataFile");
    if (equalsIgnoringCase(name, "local")) {
      m_file.stored.file = m_source.file();
      m_file.stored.bytes = m_behind;
    } else {
      if (name.starts_with("LIST") || name.find('%') != std::string_view::npos)
        return m_source.at("ElementDataFile", "its voxels are in several files, which are not read",
                           "Export it as one file");
      const std::optional<std::filesystem::path> file = fileInFolder(m_source.file(), name);
      if (!file)
        return m_source.at("ElementDataFile",
                           "refers to " + inQuotes(name) + ", which is outside the header's folder",
                           "Put the data beside the header and name only the file");
      Source data = TRY(Source::readStored(*file, m_options.limits));
      m_file.sources.push_back(std::make_shared<const Source>(std::move(data)));
      m_file.stored.file = m_file.sources.back()->file();
      m_file.stored.bytes = m_file.sources.back()->text();
    }
    std::int64_t skip = 0;
    if (!value("HeaderSize").empty() &&
        (!TextCursor(value("HeaderSize")).integer(skip) || skip < -1))
      return m_source.at("HeaderSize",
                         inQuotes(value("HeaderSize")) + " is neither a number of bytes nor -1");
    m_file.stored.fromTheEnd = skip == -1;
    m_file.stored.skip = std::uint64_t(std::max<std::int64_t>(skip, 0));
    return Unit{};
  }

  const Source& m_source;
  const ReadOptions& m_options;
  std::map<std::string, std::string_view, std::less<>> m_lines;
  std::string_view m_behind;  ///< the text behind the header
  VolumeFile m_file;
};

}  // namespace

Result<VolumeFile> openMetaImage(const std::filesystem::path& file, const ReadOptions& options) {
  Source source = TRY(Source::readStored(file, options.limits));
  const auto kept = std::make_shared<const Source>(std::move(source));
  Result<VolumeFile> volume = MetaImageReader(*kept, options).read();
  if (volume)
    volume->sources.push_back(kept);
  return volume;
}

}  // namespace sline::model
