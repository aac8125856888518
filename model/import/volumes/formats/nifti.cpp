// SPDX-License-Identifier: Apache-2.0
// Reads NIfTI-1.1 and NIfTI-2 (R. W. Cox and others, nifti.nimh.nih.gov: nifti1.h, nifti2.h), and
// Analyze 7.5, from which NIfTI's header came.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/import/volumes/formats/analyze_geometry.h"
#include "model/import/volumes/formats/free_surfer_labels.h"
#include "model/import/volumes/formats/image_pair.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

namespace {

/// Says where the fields of the two versions lie, in bytes.
struct FieldOffsets {
  std::size_t header;
  std::size_t magic;
  std::size_t dim;
  std::size_t type;
  std::size_t pixdim;
  std::size_t offset;
  std::size_t slope;
  std::size_t units;
  std::size_t forms;  ///< qform_code, sform_code
  std::size_t quaternion;
  std::size_t rows;  ///< srow_x …
};
constexpr FieldOffsets nifti1 = {348, 344, 40, 70, 76, 108, 112, 123, 252, 256, 280};
constexpr FieldOffsets nifti2 = {540, 4, 16, 12, 104, 168, 176, 500, 344, 352, 400};

std::optional<ScalarType> typeOf(std::int64_t code) {
  switch (code) {
    case 2:
      return ScalarType::uint8;
    case 4:
      return ScalarType::int16;
    case 8:
      return ScalarType::int32;
    case 16:
      return ScalarType::float32;
    case 64:
      return ScalarType::float64;
    case 256:
      return ScalarType::int8;
    case 512:
      return ScalarType::uint16;
    case 768:
      return ScalarType::uint32;
    case 1024:
      return ScalarType::int64;
    case 1280:
      return ScalarType::uint64;
    default:
      return std::nullopt;
  }
}

/// Returns the rotation of the quaternion with the given vector part (nifti1.h, "METHOD 2").
glm::dmat3 rotation(const glm::dvec3& v) {
  const double rest = 1.0 - glm::dot(v, v);
  double a = 0.0;
  glm::dvec3 q = v;
  if (rest < 1e-7)
    q = v / std::sqrt(std::max(glm::dot(v, v), 1e-30));
  else
    a = std::sqrt(rest);
  const double b = q.x;
  const double c = q.y;
  const double d = q.z;
  glm::dmat3 m;
  m[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  m[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  m[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b};
  return m;
}

class NiftiReader {
 public:
  /// Takes the header's file and that of the voxels, which is the same unless they are a pair.
  NiftiReader(const Source& source, const Source& image, const ReadOptions& options)
      : m_source(source), m_image(image), m_options(options) {}

  Result<VolumeFile> read() {
    TRY(readHeader());
    TRY(readLayout());
    m_analyze ? placeAsAnalyze() : readPlace();
    m_file.stored.file = m_image.file();
    m_file.stored.bytes = m_image.text();
    m_file.stored.packing = packingOf(m_image);
    m_file.stored.skip = m_offset;
    m_file.onlySideOpen = m_analyze;
    m_file.names = [extension = std::move(m_extension), file = m_source.file(),
                    limits = m_options.limits](const LabelVolume& volume, std::size_t) {
      LabelNames names = labelsInCaret(extension);
      std::string from;
      if (names.empty())
        names = labelsBeside(file, limits, from);
      return names.empty() ? freeSurferLabels(volume, file) : names;
    };
    return std::move(m_file);
  }

 private:
  bool isPair() const { return &m_source != &m_image; }
  static Packing packingOf(const Source& source) {
    return beginsLikeGzip(source.text()) ? Packing::deflated : Packing::none;
  }

  Status readHeader() {
    PackedBytes bytes(m_source.text(), packingOf(m_source));
    m_header.resize(nifti2.header + 4);
    const std::size_t got = bytes.read(m_header.data(), m_header.size());
    m_header.resize(got);
    const auto begins = [&](const FieldOffsets& places, bool swap) {
      return got >= places.header &&
             loadAs<std::int32_t>(m_header.data(), swap) == std::int32_t(places.header);
    };
    for (const bool swap : {false, true})
      for (const FieldOffsets* places : {&nifti1, &nifti2})
        if (!m_places && begins(*places, swap)) {
          m_places = places;
          m_swap = swap;
        }
    if (!m_places)
      return m_source.atByte(
          m_source.begin(),
          isPair() ? "does not begin like a header of NIfTI or Analyze"
                   : "does not begin like a NIfTI file",
          "Export it as NIfTI again, or give the file the extension of its kind");
    const std::string_view magic(m_header.data() + m_places->magic, 3);
    const bool two = magic == "ni1" || magic == "ni2";
    const bool one = magic == "n+1" || magic == "n+2";
    m_analyze = isPair() && !two && !one && m_places == &nifti1;
    if (isPair() ? one : two)
      return m_source.whole(one ? "says that its voxels are in the same file, yet is called .hdr"
                                : "says that its voxels are in a file of its own",
                            one ? "Call it .nii" : "Call the two files .hdr and .img");
    if (!one && !two && !m_analyze)
      return m_source.whole("has a header of Analyze, which does not say where the voxels lie",
                            "Export it as NIfTI");
    const double offset = m_places == &nifti1 ? double(number<float>(m_places->offset))
                                              : double(number<std::int64_t>(m_places->offset));
    if (!(offset >= (isPair() ? 0.0 : double(m_places->header)) && offset < 1e9))
      return m_source.whole("its header says that the voxels begin at byte " +
                            std::to_string(offset));
    m_offset = std::uint64_t(offset);
    readExtension(bytes, got);
    return Unit{};
  }

  /// Reads the bytes between header and voxels; extensions are looked through for the text they
  /// hold.
  void readExtension(PackedBytes& bytes, std::size_t got) {
    constexpr std::uint64_t longest = std::uint64_t(4) << 20;
    const std::size_t begin = m_places->header + 4;
    // The header of a pair has nothing else behind it.
    const std::uint64_t end = isPair() ? begin + longest : m_offset;
    if (end <= begin || end - begin > longest || got < begin)
      return;
    const std::size_t ahead = std::min<std::size_t>(got - begin, end - begin);
    m_extension.assign(m_header.data() + begin, ahead);
    m_extension.resize(end - begin);
    const std::size_t rest = bytes.read(m_extension.data() + ahead, m_extension.size() - ahead);
    m_extension.resize(ahead + rest);
    // Eight bytes of size and code stand before the XML.
    const std::size_t xml = m_extension.find('<');
    m_extension.erase(0, std::min(xml, m_extension.size()));
  }

  template <class T>
  T number(std::size_t at) const {
    return loadAs<T>(m_header.data() + at, m_swap);
  }
  /// Returns number `i` of a row of them, with the width that the version has.
  std::int64_t whole(std::size_t at, std::size_t i) const {
    return m_places == &nifti1 ? std::int64_t(number<std::int16_t>(at + 2 * i))
                               : number<std::int64_t>(at + 8 * i);
  }
  double real(std::size_t at, std::size_t i) const {
    return m_places == &nifti1 ? double(number<float>(at + 4 * i)) : number<double>(at + 8 * i);
  }

  Status readLayout() {
    const std::int64_t axes = whole(m_places->dim, 0);
    std::array<std::int64_t, 8> sizes;
    sizes.fill(1);
    for (std::int64_t i = 1; i <= std::clamp<std::int64_t>(axes, 0, 7); ++i)
      sizes[std::size_t(i)] = whole(m_places->dim, std::size_t(i));
    if (axes < 3 || axes > 7)
      return m_source.whole("has " + std::to_string(axes) + " axes, a volume needs three",
                            "Export a volume with three axes in space");
    m_file.layout.size = {sizes[1], sizes[2], sizes[3]};
    m_file.layout.layers = 1;
    for (std::size_t i = 4; i < 8; ++i) {
      if (m_analyze && sizes[i] == 0)
        sizes[i] = 1;
      if (sizes[i] < 1 || sizes[i] > 65'536)
        return m_source.whole("the size of its axis " + std::to_string(i) + " is " +
                              std::to_string(sizes[i]));
      m_file.layout.layers = std::min<std::int64_t>(m_file.layout.layers * sizes[i], 65'536);
    }
    const std::int64_t code = number<std::int16_t>(m_places->type);
    const std::optional<ScalarType> type = typeOf(code);
    if (!type)
      return m_source.whole("its voxels are of type " + std::to_string(code) +
                                ", which is neither of labels nor of intensities",
                            "Export it with one number per voxel");
    m_file.layout.type = *type;
    m_file.layout.order = m_swap == (std::endian::native == std::endian::little)
                              ? std::endian::big
                              : std::endian::little;
    const double slope = real(m_places->slope, 0);
    const double intercept = real(m_places->slope, 1);
    if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0.0) {
      m_file.layout.slope = slope;
      m_file.layout.intercept = intercept;
    }
    return Unit{};
  }

  void readPlace() {
    const auto code = [&](std::size_t i) {
      return m_places == &nifti1 ? std::int32_t(number<std::int16_t>(m_places->forms + 2 * i))
                                 : number<std::int32_t>(m_places->forms + 4 * i);
    };
    glm::dmat4 toRas(1.0);
    const glm::dvec3 spacing = spacings();
    m_file.frame = Frame::ras;
    if (code(1) > 0 && sform(toRas)) {
      m_file.frameReason = "sform (NIfTI is RAS)";
      if (code(0) > 0)
        compare(toRas, qform(spacing));
    } else if (code(0) > 0) {
      toRas = qform(spacing);
      m_file.frameReason = "qform (NIfTI is RAS)";
    } else {
      for (int i = 0; i < 3; ++i)
        toRas[i][i] = spacing[i];
      m_file.frame = std::nullopt;
      m_file.warnings.push_back(m_source.warning(
          "has neither sform nor qform: which side is left is taken from names, if they tell"));
    }
    const double unit = readUnit();
    // Half a turn about the long axis leads from RAS to LPS; without a frame, nothing is known.
    const double turn = m_file.frame ? -1.0 : 1.0;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        toRas[column][row] *= unit * (row < 2 ? turn : 1.0);
    m_file.toLps = toRas;
  }

  glm::dvec3 spacings() const {
    glm::dvec3 spacing;
    for (int i = 0; i < 3; ++i) {
      spacing[i] = std::abs(real(m_places->pixdim, std::size_t(i) + 1));
      if (!std::isfinite(spacing[i]) || spacing[i] == 0.0)
        spacing[i] = 1.0;
    }
    return spacing;
  }

  glm::dmat4 qform(const glm::dvec3& spacing) const {
    glm::dmat4 toRas(1.0);
    glm::dvec3 q;
    for (int i = 0; i < 3; ++i) {
      q[i] = real(m_places->quaternion, std::size_t(i));
      toRas[3][i] = real(m_places->quaternion, std::size_t(i) + 3);
    }
    const glm::dmat3 turn = rotation(q);
    const double sign = real(m_places->pixdim, 0) < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i)
      toRas[i] = glm::dvec4(turn[i] * spacing[i] * (i == 2 ? sign : 1.0), 0.0);
    return toRas;
  }

  /// Says where the two places that the header gives do not agree. A sheared sform has no qform
  /// that is equal to it, so half a voxel is let pass.
  void compare(const glm::dmat4& sform, const glm::dmat4& qform) {
    double farthest = 0.0;
    double voxel = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec4 at(0.0, 0.0, 0.0, 1.0);
      for (int i = 0; i < 3; ++i)
        at[i] = (corner >> i & 1) != 0 ? double(m_file.layout.size[i] - 1) : 0.0;
      farthest = std::max(farthest, glm::length(glm::dvec3((sform - qform) * at)));
    }
    for (int i = 0; i < 3; ++i)
      voxel = std::max(voxel, glm::length(glm::dvec3(sform[i])));
    if (!(farthest > 0.5 * voxel))
      return;
    const bool mirrored =
        glm::determinant(glm::dmat3(sform)) * glm::determinant(glm::dmat3(qform)) < 0.0;
    m_file.warnings.push_back(m_source.warning(
        "sform and qform place it differently, by up to " +
        std::to_string(std::lround(std::max(farthest, 1.0))) +
        (mirrored ? " of its units and with left and right swapped; the sform was taken"
                  : " of its units; the sform was taken")));
  }

  void placeAsAnalyze() {
    const AnalyzeGeometry place = analyzeGeometry(m_header.data(), m_swap);
    m_file.toLps = place.toMillimetres;
    m_file.unitReason = place.unitReason;
    m_file.warnings.push_back(m_source.warning(
        "is an Analyze file, which does not say which side is left: that is taken from names, if "
        "they tell, else the first voxels are at the patient's right, as most programs write"));
  }

  /// Reads the sform; directions of no length are none, whatever its code says.
  bool sform(glm::dmat4& toRas) const {
    glm::dmat4 found(1.0);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        found[int(column)][int(row)] = real(m_places->rows, 4 * row + column);
    if (std::abs(glm::determinant(glm::dmat3(found))) > 0.0)
      toRas = found;
    return toRas == found;
  }

  double readUnit() {
    const int code = m_places == &nifti1 ? int(number<std::uint8_t>(m_places->units))
                                         : int(number<std::int32_t>(m_places->units));
    switch (code & 7) {
      case 1:
        m_file.unitReason = "header: metres";
        return 1000.0;
      case 2:
        m_file.unitReason = "header: millimetres";
        return 1.0;
      case 3:
        m_file.unitReason = "header: micrometres";
        return 0.001;
      default:
        m_file.unitReason = "NIfTI without a unit is in millimetres";
        return 1.0;
    }
  }

  const Source& m_source;
  const Source& m_image;
  const ReadOptions& m_options;
  bool m_analyze = false;
  std::vector<char> m_header;
  std::string m_extension;
  const FieldOffsets* m_places = nullptr;
  bool m_swap = false;
  std::uint64_t m_offset = 0;
  VolumeFile m_file;
};

}  // namespace

Result<VolumeFile> openNifti(const std::filesystem::path& file, const ReadOptions& options) {
  ImagePair pair{file, file};
  if (isOfImagePair(file)) {
    pair = TRY(imagePairOf(file));
  }
  std::vector<std::shared_ptr<const Source>> sources;
  for (const std::filesystem::path& one : {pair.header, pair.image}) {
    if (!sources.empty() && pair.header == pair.image)
      break;
    Source source = TRY(Source::readStored(one, options.limits));
    sources.push_back(std::make_shared<const Source>(std::move(source)));
  }
  Result<VolumeFile> volume = NiftiReader(*sources.front(), *sources.back(), options).read();
  if (volume)
    volume->sources = std::move(sources);
  return volume;
}

}  // namespace sline::model
