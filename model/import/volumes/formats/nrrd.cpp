// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "model/base/letters.h"
#include "model/import/source/file_in_folder.h"
#include "model/import/source/text_cursor.h"
#include "model/import/volumes/formats/nrrd_fields.h"
#include "model/import/volumes/formats/nrrd_header.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

namespace {

constexpr const char* threeAxes = "Export a volume with three axes in space";

class NrrdReader {
 public:
  NrrdReader(const Source& source, NrrdHeader header, const ReadOptions& options)
      : m_source(source), m_header(std::move(header)), m_options(options) {}

  Result<VolumeFile> read() {
    TRY(readAxes());
    TRY(readPlace());
    TRY(readType());
    TRY(findData());
    const bool segments =
        !m_header.key("Segment0_LabelValue").empty() || !m_header.key("Segment0_Name").empty();
    m_file.layersMeant = segments;
    m_file.names = [header = std::move(m_header), segments, layered = m_file.layout.layers > 1,
                    file = m_source.file(),
                    limits = m_options.limits](const LabelVolume&, std::size_t layer) {
      std::string from;
      return segments ? nrrdSegments(header, layered, layer) : labelsBeside(file, limits, from);
    };
    return std::move(m_file);
  }

 private:
  /// Reads the sizes, and which axis counts layers, if one does.
  Status readAxes() {
    std::int64_t dimension = 0;
    TextCursor(m_header.field("dimension")).integer(dimension);
    TextCursor at(m_header.field("sizes"));
    for (at.skipSpace(); !at.atEnd(); at.skipSpace()) {
      std::int64_t size = 0;
      if (!at.integer(size) || size < 1 || m_sizes.size() > 16)
        return m_source.at("field sizes",
                           "is no list of sizes: " + inQuotes(m_header.field("sizes")));
      m_sizes.push_back(size);
    }
    if (m_sizes.empty() || std::int64_t(m_sizes.size()) != dimension)
      return m_source.at("field sizes", "there are " + std::to_string(m_sizes.size()) +
                                            " sizes for the dimension " +
                                            std::to_string(dimension));
    m_directions = nrrdVectors(m_header.field("space directions"));
    if (!m_directions.empty() && m_directions.size() != m_sizes.size())
      return m_source.at("field space directions", "there is not one vector for each axis");
    if (m_sizes.size() < 3)
      return m_source.at("field dimension",
                         "has " + std::to_string(m_sizes.size()) +
                             (m_sizes.size() == 1 ? " axis" : " axes") + ", a volume needs three",
                         threeAxes);
    std::vector<std::size_t> spatial;
    const std::vector<std::string_view> kinds = nrrdWords(m_header.field("kinds"));
    for (std::size_t i = 0; i < m_sizes.size(); ++i)
      if (isSpatial(i, kinds))
        spatial.push_back(i);
    dropListOfOne(spatial);
    const bool contiguous =
        spatial.size() == 3 && spatial[2] - spatial[0] == 2 && m_sizes.size() <= 4;
    if (!contiguous)
      return m_source.at("field sizes",
                         "has " + std::to_string(m_sizes.size()) + " axes, of which " +
                             std::to_string(spatial.size()) + " lie in space",
                         threeAxes);
    m_first = spatial[0];
    m_file.layout.size = {m_sizes[m_first], m_sizes[m_first + 1], m_sizes[m_first + 2]};
    if (m_sizes.size() == 4) {
      const std::size_t other = m_first == 0 ? 3 : 0;
      m_file.layout.layers = m_sizes[other];
      m_file.layout.interleaved = other == 0;
      if (other < kinds.size() && kinds[other] != "list" && kinds[other] != "???" &&
          kinds[other] != "none" && m_file.layout.layers > 1)
        return m_source.at("field kinds",
                           "holds " + inQuotes(kinds[other]) +
                               " in each voxel, which is neither label nor intensity",
                           "Export a volume with one number per voxel");
    }
    return Unit{};
  }

  /// Takes from four axes in space one that has a single place: a volume written as a list of one,
  /// whose list has a direction of its own.
  void dropListOfOne(std::vector<std::size_t>& spatial) const {
    if (spatial.size() != 4 || m_sizes.size() != 4)
      return;
    const std::size_t list = m_sizes[3] == 1 ? 3 : m_sizes[0] == 1 ? 0 : 4;
    std::erase(spatial, list);
  }

  bool isSpatial(std::size_t axis, const std::vector<std::string_view>& kinds) const {
    if (!m_directions.empty())
      return m_directions[axis].has_value();
    if (m_sizes.size() == 3)
      return true;
    return axis < kinds.size() && (kinds[axis] == "domain" || kinds[axis] == "space");
  }

  Status readPlace() {
    const NrrdSpace space = TRY(nrrdSpace(m_source, m_header));
    glm::dmat4& place = m_file.toLps;
    if (m_directions.empty()) {
      TextCursor at(m_header.field("spacings"));
      double spacing = 0.0;
      for (std::size_t i = 0; i < m_first + 3; ++i) {
        at.skipSpace();
        const bool given = at.number(spacing) && std::isfinite(spacing) && spacing != 0.0;
        if (i >= m_first) {
          const int axis = int(i - m_first);
          place[axis][axis] = given ? spacing : 1.0;
        }
      }
    } else {
      for (int i = 0; i < 3; ++i)
        place[i] = glm::dvec4(*m_directions[m_first + std::size_t(i)], 0.0);
    }
    const auto origin = nrrdVectors(m_header.field("space origin"));
    if (origin.size() == 1 && origin.front())
      place[3] = glm::dvec4(*origin.front(), 1.0);
    const bool ofSlicerRt = moveByExtent(!space.frame) && !space.frame;
    const glm::dvec3 toLps = ofSlicerRt ? glm::dvec3(-1.0, -1.0, 1.0) : space.toLps;
    const double unit = nrrdUnit(m_header);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        place[column][row] *= toLps[row] * (unit > 0.0 ? unit : 1.0);
    m_file.frame = ofSlicerRt ? std::optional(Frame::ras) : space.frame;
    m_file.frameReason = ofSlicerRt ? "SlicerRT's segmentations are RAS"
                                    : "space: " + std::string(m_header.field("space"));
    m_file.unitReason = unit > 0.0 ? "header: space units" : "volumes are in millimetres";
    return Unit{};
  }

  /// Moves the first voxel to its place in the reference image where the origin is that image's;
  /// returns whether it is. Segmentations of SlicerRT and its time's 3D Slicer say which voxels
  /// of the reference image they hold (Segmentation_Extent), in its own coordinates, RAS. Later
  /// ones say so too (Segmentation_ReferenceImageExtentOffset), but have an origin of their own.
  bool moveByExtent(bool spaceless) {
    const std::string_view text = m_header.key("Segmentation_Extent");
    if (text.empty())
      return false;
    std::array<std::int64_t, 6> extent{};
    TextCursor at(text);
    bool fits = true;
    for (std::int64_t& each : extent) {
      at.skipSpace();
      fits = fits && at.integer(each) && std::abs(each) < 100'000;
    }
    const glm::i64vec3& size = m_file.layout.size;
    for (std::size_t axis = 0; fits && axis < 3; ++axis)
      fits = extent[2 * axis + 1] - extent[2 * axis] + 1 == size[int(axis)];
    const std::string says = "says that it holds the voxels " + inQuotes(text);
    if (!fits) {
      m_file.warnings.push_back(m_source.warning(
          says +
          " of a reference image, which are not as many as it has; it was placed as if its "
          "origin were its own"));
      return false;
    }
    if (extent[0] == 0 && extent[2] == 0 && extent[4] == 0)
      return spaceless;
    if (!m_header.key("Segmentation_ReferenceImageExtentOffset").empty()) {
      m_file.warnings.push_back(
          m_source.warning(says + " of a reference image, and an offset in it, as files with an "
                                  "origin of their own do; it was placed by its origin alone"));
      return false;
    }
    if (!spaceless)
      m_file.warnings.push_back(m_source.warning(
          says + " of a reference image; its origin was taken to be that image's"));
    for (std::size_t axis = 0; axis < 3; ++axis)
      m_file.toLps[3] += double(extent[2 * axis]) * m_file.toLps[int(axis)];
    return true;
  }

  Status readType() {
    const std::string_view name = m_header.field("type");
    const std::optional<ScalarType> type = nrrdType(name);
    if (!type)
      return m_source.at("field type", "its type " + inQuotes(name) + " is not one of numbers",
                         "Export it as unsigned short");
    m_file.layout.type = *type;
    const std::string_view encoding = m_header.field("encoding");
    const auto is = [&](std::initializer_list<std::string_view> names) {
      return std::any_of(names.begin(), names.end(), [&](std::string_view known) {
        return equalsIgnoringCase(encoding, known);
      });
    };
    if (is({"gzip", "gz"}))
      m_file.stored.packing = Packing::deflated;
    else if (is({"bzip2", "bz2"}))
      m_file.stored.packing = Packing::bzip2;
    else if (is({"hex"}))
      m_file.stored.packing = Packing::hex;
    else if (is({"txt", "text", "ascii"}))
      m_file.stored.text = true;
    else if (!is({"raw"}))
      return m_source.at("field encoding",
                         "its encoding " + inQuotes(encoding) + " is not supported",
                         "Export it raw or with gzip");
    const std::string_view endian = m_header.field("endian");
    if (equalsIgnoringCase(endian, "big"))
      m_file.layout.order = std::endian::big;
    else if (!equalsIgnoringCase(endian, "little") && sizeOf(*type) > 1 && !m_file.stored.text)
      m_file.warnings.push_back(
          m_source.warning("does not say in which order its bytes are; taken as little-endian"));
    return Unit{};
  }

  Status findData() {
    m_file.stored.file = m_source.file();
    m_file.stored.bytes = m_header.data;
    if (const std::string_view name = m_header.field("data file"); !name.empty()) {
      TRY(openData(name));
      m_file.stored.file = m_file.sources.back()->file();
      m_file.stored.bytes = m_file.sources.back()->text();
    }
    std::int64_t lines = 0;
    TextCursor(m_header.field("line skip")).integer(lines);
    TextCursor at(m_file.stored.bytes);
    for (; lines > 0 && !at.atEnd(); --lines)
      at.skipLine();
    m_file.stored.bytes = {at.at(), std::size_t(at.end() - at.at())};
    if (const std::string_view text = m_header.field("byte skip"); !text.empty()) {
      std::int64_t bytes = 0;
      if (!TextCursor(text).integer(bytes) || bytes < -1)
        return m_source.at("field byte skip",
                           inQuotes(text) + " is neither a number of bytes nor -1",
                           "Write how many bytes come before the voxels");
      m_file.stored.fromTheEnd = bytes == -1;
      m_file.stored.skip = std::uint64_t(std::max<std::int64_t>(bytes, 0));
    }
    skipNiftiHeader();
    return Unit{};
  }

  Status openData(std::string_view name) {
    if (name.starts_with("LIST") || name.find('%') != std::string_view::npos)
      return m_source.at("field data file", "its voxels are in several files, which are not read",
                         "Export it as one file");
    const std::optional<std::filesystem::path> file = fileInFolder(m_source.file(), name);
    if (!file)
      return m_source.at("field data file",
                         "refers to " + inQuotes(name) + ", which is outside the header's folder",
                         "Put the data beside the header and name only the file");
    Source data = TRY(Source::readStored(*file, m_options.limits));
    m_file.sources.push_back(std::make_shared<const Source>(std::move(data)));
    return Unit{};
  }

  /// Skips a NIfTI header: an NRRD header may be laid over a NIfTI file; unless it says how much
  /// comes before the voxels, its first voxels would be the NIfTI header.
  void skipNiftiHeader() {
    constexpr std::size_t magic = 344;
    if (m_file.sources.empty() || m_file.stored.fromTheEnd || m_file.stored.skip > 0 ||
        m_file.stored.text ||
        !unpackedBytesHave(m_file.stored, magic, std::string_view("n+1\0", 4)))
      return;
    m_file.stored.fromTheEnd = true;
    m_file.warnings.push_back(m_source.warning(
        "its data file is a NIfTI volume, of which the header was passed over; open " +
        inQuotes(std::filesystem::path(m_file.sources.back()->file()).filename().string()) +
        " itself to have its own directions"));
  }

  const Source& m_source;
  NrrdHeader m_header;
  const ReadOptions& m_options;
  std::vector<std::int64_t> m_sizes;
  std::vector<std::optional<glm::dvec3>> m_directions;  ///< directions of all axes, or none
  std::size_t m_first = 0;                              ///< index of the first axis in space
  VolumeFile m_file;
};

}  // namespace

Result<VolumeFile> openNrrd(const std::filesystem::path& file, const ReadOptions& options) {
  Source source = TRY(Source::readStored(file, options.limits));
  const auto kept = std::make_shared<const Source>(std::move(source));
  NrrdHeader header = TRY(nrrdHeader(*kept));
  Result<VolumeFile> volume = NrrdReader(*kept, std::move(header), options).read();
  if (volume)
    volume->sources.push_back(kept);
  return volume;
}

}  // namespace sline::model
