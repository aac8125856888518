// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/image_series.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "model/import/dicom/frame_attributes.h"
#include "model/import/dicom/pixel_frames.h"

namespace sline::model {

namespace {

constexpr Tag seriesUid{0x0020, 0x000e};
constexpr Tag bitsStored{0x0028, 0x0101};
constexpr Tag highestBit{0x0028, 0x0102};
constexpr Tag pixelRepresentation{0x0028, 0x0103};
/// A series may have 1024 slices of 1024 × 1024 pixels; a small file that asks for many is limited
/// by its bytes.
constexpr std::uint64_t mostSeriesVoxels = std::uint64_t(1) << 30;
constexpr std::uint64_t voxelsOfAny = std::uint64_t(128) << 20;
constexpr std::uint64_t seriesVoxelsPerByte = 1024;
/// Images nearer to each other than this show one place, mm.
constexpr double onePlace = 1e-4;
/// Places may differ from an even grid by this much: they are often rounded to 0.01 mm.
constexpr double unevenBy = 0.05;  ///< as a share of the slices' distance
constexpr double roundedBy = 0.011;
constexpr double levels = 65535.0;
constexpr const char* sortThem = "Give the slices of one series, of one orientation and size";
constexpr const char* giveAll =
    "Give all slices of the series, or have another program resample it evenly";

std::string millimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", length);
  return text;
}

struct Slice {
  FrameAttributes place;
  std::vector<std::int16_t> stored;
};

/// Says how 16 bits are to be read as a number.
struct StoredNumber {
  unsigned shift = 0;
  unsigned bits = 16;
  bool isSigned = false;

  static StoredNumber in(const DataSet& data, int allocated) {
    StoredNumber number;
    number.bits =
        std::clamp(data.number(bitsStored).value_or(unsigned(allocated)), 1u, unsigned(allocated));
    const unsigned high = data.number(highestBit).value_or(number.bits - 1);
    number.shift =
        high + 1 > number.bits && high < unsigned(allocated) ? high + 1 - number.bits : 0;
    number.isSigned = data.number(pixelRepresentation).value_or(0) == 1;
    return number;
  }
  /// Returns what is subtracted so that unsigned numbers fit in signed ones.
  int offset() const { return !isSigned && bits == 16 ? 32768 : 0; }
  std::int16_t value(std::uint16_t pixel) const {
    const unsigned mask = (1u << bits) - 1u;
    int number = int((unsigned(pixel) >> shift) & mask);
    if (isSigned && (unsigned(number) >> (bits - 1)) != 0)
      number -= int(mask) + 1;
    return std::int16_t(number - offset());
  }
};

class SeriesReader {
 public:
  SeriesReader(std::span<const std::filesystem::path> files, const ReadOptions& options)
      : m_files(files), m_options(options) {}

  Result<GreyVolume> read() {
    if (m_files.empty())
      return Error{{}, {}, "there are no slices to read", "Give the slices of a series"};
    for (const std::filesystem::path& file : m_files) {
      if (!m_options.goesOn())
        return Error{file.string(), {}, "was not read to its end", "Read the series again"};
      TRY(addFile(file));
    }
    TRY(sort());
    return assembled();
  }

 private:
  Error wrong(std::string reason, const char* remedy) const {
    return Error{m_files.front().string(), {}, std::move(reason), remedy};
  }

  Status addFile(const std::filesystem::path& path) {
    const DicomFile file = TRY(DicomFile::read(path, m_options.limits));
    const std::string scanner(scannerOf(file.sopClass()));
    if (scanner.empty()) {
      const std::string kind(objectName(file.sopClass()));
      return file.source().whole("is no slice of CT, MR or PET" +
                                     (kind.empty() ? "" : ": its content is of the kind " + kind),
                                 sortThem);
    }
    const std::string series = file.data().text(seriesUid);
    if (m_slices.empty()) {
      m_scanner = scanner;
      m_series = series;
    }
    if (scanner != m_scanner || series != m_series)
      return file.source().whole("belongs to another series than the first slice", sortThem);
    m_bytes += file.source().size();
    return addFrames(file);
  }

  Status addFrames(const DicomFile& file) {
    const PixelFrames pixels = TRY(PixelFrames::open(file));
    const std::vector<FrameAttributes> places = TRY(frameAttributesIn(file));
    if (places.size() != pixels.frames() || pixels.bits() == 1)
      return file.source().whole("has " + std::to_string(pixels.frames()) + " frames of " +
                                     std::to_string(pixels.bits()) + " bits but tells where " +
                                     std::to_string(places.size()) + " of them lie",
                                 "Export the images again");
    const glm::ivec2 size(pixels.columns(), pixels.rows());
    if (m_slices.empty())
      m_size = size;
    if (size != m_size)
      return file.source().whole("has " + std::to_string(size.x) + " × " + std::to_string(size.y) +
                                     " pixels, the first slice " + std::to_string(m_size.x) +
                                     " × " + std::to_string(m_size.y),
                                 sortThem);
    const std::uint64_t voxels =
        std::uint64_t(pixels.frameSize()) * (m_slices.size() + pixels.frames());
    if (voxels > std::min(mostSeriesVoxels, voxelsOfAny + seriesVoxelsPerByte * m_bytes))
      return file.source().whole("the series has more voxels than are read",
                                 "Have another program reduce its resolution");
    const StoredNumber number = StoredNumber::in(file.data(), pixels.bits());
    std::vector<std::uint16_t> values;
    for (std::size_t f = 0; f < places.size(); ++f) {
      TRY(pixels.frame(f, values));
      Slice slice{places[f], std::vector<std::int16_t>(values.size())};
      std::transform(values.begin(), values.end(), slice.stored.begin(),
                     [&](std::uint16_t value) { return number.value(value); });
      slice.place.intercept += slice.place.slope * number.offset();
      if (!fits(slice.place))
        return file.source().at("frame " + std::to_string(f + 1),
                                "is turned or scaled otherwise than the first slice", sortThem);
      m_slices.push_back(std::move(slice));
    }
    return Unit{};
  }

  bool fits(const FrameAttributes& place) const {
    if (m_slices.empty())
      return true;
    const FrameAttributes& first = m_slices.front().place;
    return glm::dot(place.along, first.along) > 0.9999 &&
           glm::dot(place.down, first.down) > 0.9999 &&
           std::abs(place.rowSpacing - first.rowSpacing) < 1e-3 * first.rowSpacing &&
           std::abs(place.columnSpacing - first.columnSpacing) < 1e-3 * first.columnSpacing;
  }

  double heightOf(const Slice& slice) const { return glm::dot(slice.place.position, m_normal); }

  /// Sorts the slices by their place, and tells whether they make a grid.
  Status sort() {
    if (m_slices.size() < 2)
      return wrong("is a single slice, which makes no volume", giveAll);
    m_normal = glm::cross(m_slices.front().place.along, m_slices.front().place.down);
    std::stable_sort(m_slices.begin(), m_slices.end(),
                     [&](const Slice& a, const Slice& b) { return heightOf(a) < heightOf(b); });
    std::vector<double> gaps;
    for (std::size_t i = 1; i < m_slices.size(); ++i)
      gaps.push_back(heightOf(m_slices[i]) - heightOf(m_slices[i - 1]));
    const auto same =
        std::count_if(gaps.begin(), gaps.end(), [](double gap) { return gap < onePlace; });
    if (same > 0)
      return wrong(std::to_string(same) +
                       " of its images lie where another one does: the series has several phases, "
                       "echoes or copies",
                   "Give the images of one of them");
    std::vector<double> sorted = gaps;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                     sorted.end());
    const double usual = sorted[sorted.size() / 2];
    const double tolerance = std::max(unevenBy * usual, roundedBy);
    for (const double gap : gaps)
      if (std::abs(gap - usual) > tolerance)
        return wrong("its slices are not evenly spaced: two lie " + millimetres(gap) +
                         " apart, most others " + millimetres(usual) +
                         (gap > usual ? "; slices may be missing" : ""),
                     giveAll);
    m_step = (m_slices.back().place.position - m_slices.front().place.position) /
             double(m_slices.size() - 1);
    const FrameAttributes& first = m_slices.front().place;
    for (std::size_t i = 0; i < m_slices.size(); ++i) {
      const glm::dvec3 off = m_slices[i].place.position - first.position - double(i) * m_step;
      if (std::abs(glm::dot(off, m_normal)) > 2.0 * tolerance ||
          std::abs(glm::dot(off, first.along)) > 0.5 * first.columnSpacing ||
          std::abs(glm::dot(off, first.down)) > 0.5 * first.rowSpacing)
        return wrong("its slices do not lie above each other on one grid", giveAll);
    }
    return Unit{};
  }

  /// Finds one scale for all: that of the slices or, where PET and MR give each slice its own, one
  /// that spans all values in 65,536 levels.
  void findScale(GreyVolume& volume) {
    const FrameAttributes& first = m_slices.front().place;
    volume.slope = first.slope;
    volume.intercept = first.intercept;
    const bool alike = std::all_of(m_slices.begin(), m_slices.end(), [&](const Slice& slice) {
      return slice.place.slope == first.slope && slice.place.intercept == first.intercept;
    });
    if (alike)
      return;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Slice& slice : m_slices) {
      const auto [least, most] = std::minmax_element(slice.stored.begin(), slice.stored.end());
      for (const double stored : {double(*least), double(*most)}) {
        low = std::min(low, slice.place.slope * stored + slice.place.intercept);
        high = std::max(high, slice.place.slope * stored + slice.place.intercept);
      }
    }
    volume.slope = high > low ? (high - low) / levels : 1.0;
    volume.intercept = low + 32768.0 * volume.slope;
    for (Slice& slice : m_slices)
      for (std::int16_t& stored : slice.stored) {
        const double value = slice.place.slope * stored + slice.place.intercept;
        stored = std::int16_t(
            std::clamp(std::round((value - volume.intercept) / volume.slope), -32768.0, 32767.0));
      }
  }

  GreyVolume assembled() {
    const FrameAttributes first = m_slices.front().place;
    GreyVolume volume;
    volume.size = {m_size.x, m_size.y, int(m_slices.size())};
    volume.hounsfield =
        m_scanner == "CT" && std::all_of(m_slices.begin(), m_slices.end(), [](const Slice& slice) {
          return slice.place.unit.empty() || slice.place.unit == "HU";
        });
    volume.name = m_scanner;
    findScale(volume);
    volume.toLps = {glm::dvec4(first.along * first.columnSpacing, 0),
                    glm::dvec4(first.down * first.rowSpacing, 0), glm::dvec4(m_step, 0),
                    glm::dvec4(first.position, 1)};
    volume.frame = Frame::lps;
    volume.frameReason = "DICOM: patient coordinates";
    volume.unitReason = dicomUnit;
    volume.voxels.reserve(m_slices.size() * m_slices.front().stored.size());
    for (Slice& slice : m_slices) {
      volume.voxels.insert(volume.voxels.end(), slice.stored.begin(), slice.stored.end());
      slice.stored = {};
    }
    return volume;
  }

  std::span<const std::filesystem::path> m_files;
  const ReadOptions& m_options;
  std::string m_scanner;
  std::string m_series;  ///< never handed on
  glm::ivec2 m_size{0};
  std::uint64_t m_bytes = 0;
  std::vector<Slice> m_slices;
  glm::dvec3 m_normal{0, 0, 1};
  glm::dvec3 m_step{0, 0, 1};  ///< from one slice to the next, mm
};

}  // namespace

std::vector<DicomSeries> imageSeries(std::span<const std::filesystem::path> files,
                                     const ReadOptions& options) {
  std::vector<DicomSeries> all;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const std::filesystem::path& path : files) {
    if (!options.goesOn())
      break;
    const Result<DicomFile> file = DicomFile::readBeginning(path, options.limits);
    if (!file || scannerOf(file->sopClass()).empty())
      continue;
    const std::string scanner(scannerOf(file->sopClass()));
    const auto [at, fresh] = known.try_emplace({scanner, file->data().text(seriesUid)}, all.size());
    if (fresh)
      all.push_back({scanner, {}});
    all[at->second].files.push_back(path);
  }
  std::stable_sort(all.begin(), all.end(), [](const DicomSeries& a, const DicomSeries& b) {
    return a.files.size() > b.files.size();
  });
  return all;
}

Result<GreyVolume> seriesVolume(std::span<const std::filesystem::path> files,
                                const ReadOptions& options) {
  return SeriesReader(files, options).read();
}

}  // namespace sline::model
