// SPDX-License-Identifier: Apache-2.0
// Reads MINC 1 (McConnell Brain Imaging Centre, "MINC Programmer's Guide"): a netCDF file with a
// variable "image" along xspace, yspace and zspace in any order. Its world is RAS: +x right, +y
// anterior, +z superior. (VTK's reader would bring libraries that open connections, and turn axes
// about.)
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/import/volumes/formats/netcdf_header.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

namespace {

constexpr std::array<std::string_view, 3> worldAxes{"xspace", "yspace", "zspace"};

class MincReader {
 public:
  MincReader(const Source& source, const NetcdfHeader& header, const ReadOptions& options)
      : m_source(source), m_header(header), m_options(options) {}

  Result<VolumeFile> read() {
    const auto found = m_header.variables.find("image");
    if (found == m_header.variables.end())
      return m_source.whole("is netCDF without a variable 'image', so not MINC");
    const NetcdfVariable& image = found->second;
    TRY(readAxes(image));
    TRY(readScale(image));
    const bool isSigned = image.text("signtype").starts_with("signed");
    m_file.layout.type = withSign(image.values.type, isSigned);
    m_file.layout.order = std::endian::big;
    m_file.stored.file = m_source.file();
    m_file.stored.bytes = image.values.bytes;
    m_file.frame = Frame::ras;
    m_file.frameReason = "MINC's world is RAS";
    m_file.unitReason = "MINC is in millimetres";
    m_file.names = [file = m_source.file(), limits = m_options.limits](const LabelVolume&,
                                                                       std::size_t) {
      std::string from;
      return labelsBeside(file, limits, from);
    };
    return std::move(m_file);
  }

 private:
  /// Returns the type with its sign. The type says how many bytes; an attribute says whether they
  /// have a sign; where it is silent, bytes have none and others have one.
  static ScalarType withSign(ScalarType type, bool isSigned) {
    switch (type) {
      case ScalarType::int8:
      case ScalarType::uint8:
        return isSigned ? ScalarType::int8 : ScalarType::uint8;
      default:
        return type;
    }
  }

  Status readAxes(const NetcdfVariable& image) {
    if (image.dimensions.size() != 3)
      return m_source.at(
          "image", "has " + std::to_string(image.dimensions.size()) + " axes, a volume needs three",
          "Export a label volume with three axes in space");
    glm::dmat4 toRas(1.0);
    glm::dvec3 origin(0.0);
    unsigned seen = 0;
    for (int i = 0; i < 3; ++i) {
      // The last dimension is the fastest.
      const NetcdfDimension& dimension = m_header.dimensions[image.dimensions[std::size_t(2 - i)]];
      const auto axis = std::find(worldAxes.begin(), worldAxes.end(), dimension.name);
      if (axis == worldAxes.end() || dimension.size == 0)
        return m_source.at("image",
                           "has an axis " + inQuotes(dimension.name) + ", which is none in space");
      const auto which = std::size_t(axis - worldAxes.begin());
      seen |= 1u << which;
      m_file.layout.size[i] = std::int64_t(dimension.size);
      const auto [along, start] = alongAxis(dimension.name, which);
      toRas[i] = glm::dvec4(along, 0.0);
      origin += start;
    }
    toRas[3] = glm::dvec4(origin, 1.0);
    if (seen != 7 || !isFinite(toRas) || glm::determinant(toRas) == 0.0)
      return m_source.at("image", "its axes do not span a space");
    glm::dmat4 turned(1.0);
    turned[0][0] = turned[1][1] = -1.0;
    m_file.toLps = turned * toRas;
    return Unit{};
  }

  /// Returns a step along the axis, and where the axis starts.
  std::pair<glm::dvec3, glm::dvec3> alongAxis(const std::string& name, std::size_t which) const {
    static const NetcdfVariable none;
    const auto found = m_header.variables.find(name);
    const NetcdfVariable& axis = found == m_header.variables.end() ? none : found->second;
    std::vector<double> along(3, 0.0);
    along[which] = 1.0;
    along = axis.numbers("direction_cosines", along);
    glm::dvec3 direction(along[0], along[1], along[2]);
    if (const double length = glm::length(direction); length > 0.0)
      direction /= length;
    return {direction * axis.numbers("step", {1.0})[0],
            direction * axis.numbers("start", {0.0})[0]};
  }

  /// Reads the scale: stored numbers stand for those between image-min and image-max, slice by
  /// slice.
  Status readScale(const NetcdfVariable& image) {
    const auto range = [&](std::string_view name, double otherwise) -> std::optional<double> {
      const auto found = m_header.variables.find(name);
      if (found == m_header.variables.end())
        return otherwise;
      const NetcdfValues& values = found->second.values;
      const std::size_t there = std::min(values.count, values.bytes.size() / sizeOf(values.type));
      for (std::size_t i = 1; i < there; ++i)
        if (values.number(i) != values.number(0))
          return std::nullopt;
      return there == 0 ? otherwise : values.number(0);
    };
    const std::vector<double> valid = image.numbers("valid_range", {0.0, 0.0});
    if (valid[0] == valid[1])
      return Unit{};
    const std::optional<double> least = range("image-min", valid[0]);
    const std::optional<double> most = range("image-max", valid[1]);
    if (!least || !most)
      return m_source.at("image-max", "its slices are scaled differently, as an image's are",
                         "Choose a label volume");
    m_file.layout.slope = (*most - *least) / (valid[1] - valid[0]);
    m_file.layout.intercept = *least - m_file.layout.slope * valid[0];
    return Unit{};
  }

  const Source& m_source;
  const NetcdfHeader& m_header;
  const ReadOptions& m_options;
  VolumeFile m_file;
};

}  // namespace

Result<VolumeFile> openMinc(const std::filesystem::path& file, const ReadOptions& options) {
  Source source = TRY(Source::read(file, options.limits));
  if (source.text().starts_with("\x89HDF"))
    return source.whole("is MINC 2 (HDF5), of which only MINC 1 is read",
                        "Convert it to MINC 1 (mincconvert) or NIfTI (mnc2nii)");
  const auto kept = std::make_shared<const Source>(std::move(source));
  const NetcdfHeader header = TRY(readNetcdfHeader(*kept));
  Result<VolumeFile> volume = MincReader(*kept, header, options).read();
  if (volume)
    volume->sources.push_back(kept);
  return volume;
}

}  // namespace sline::model
