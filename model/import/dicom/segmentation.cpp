// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segmentation.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/import/dicom/frame_attributes.h"
#include "model/import/dicom/pixel_frames.h"
#include "model/import/dicom/segment_table.h"
#include "model/import/volumes/label_surfaces.h"

namespace sline::model {

namespace {

/// So many slices may lie between the first and the last for each that has a frame.
constexpr double mostSlicesPerFrame = 8.0;
constexpr std::size_t mostLabels = 65'000;
constexpr std::size_t pixelValues = 65'536;
constexpr Tag segmentationType{0x0062, 0x0001};
constexpr Tag greatestFraction{0x0062, 0x000e};
constexpr Tag pixelPadding{0x0028, 0x0120};

/// Volumes of segments that overlap may have this many voxels together, and so many more for each
/// byte of the file.
constexpr std::uint64_t mostVoxels = std::uint64_t(128) << 20;
constexpr std::uint64_t voxelsPerByte = 64;

/// Holds voxels of one row that follow each other.
struct Run {
  std::size_t begin = 0;
  std::size_t length = 0;
};

/// Bounds the part of the frames that is not empty, as half-open ranges of columns, rows and
/// slices.
struct Region {
  glm::ivec3 low{0x7fffffff};
  glm::ivec3 high{0};
  bool empty() const { return low.x >= high.x; }
};

class SegmentationReader {
 public:
  SegmentationReader(const DicomFile& file, const ReadOptions& options)
      : m_file(file), m_options(options) {}

  Result<LabelVolumes> read() {
    m_segments = segmentsIn(m_file);
    Result<PixelFrames> pixels = PixelFrames::open(m_file);
    if (!pixels)
      return pixels.error();
    m_pixels = std::move(*pixels);
    if (std::optional<Error> error = readType())
      return *error;
    Result<std::vector<FrameAttributes>> frames = frameAttributesIn(m_file);
    if (!frames)
      return frames.error();
    m_frames = std::move(*frames);
    if (m_frames.size() != m_pixels->frames() || m_frames.empty())
      return m_file.source().whole("has " + std::to_string(m_pixels->frames()) +
                                       " frames but tells where " +
                                       std::to_string(m_frames.size()) + " of them lie",
                                   "Export the segmentation again");
    if (std::optional<Error> error = stack())
      return *error;
    if (std::optional<Error> error = measure())
      return *error;
    if (m_region.empty())
      return m_file.source().whole("none of its segments has a pixel",
                                   "Draw a segment and export the segmentation again");
    if (std::optional<Error> error = m_labelMap ? paintMap() : paint())
      return *error;
    return std::move(m_result);
  }

 private:
  Error given() const { return m_file.source().whole("was not read to its end"); }

  /// Reads what values mean: in a binary segmentation inside and outside; of fractions, half the
  /// greatest and more is inside; in a label map each value is a segment's number and one is the
  /// background.
  std::optional<Error> readType() {
    const std::string type = m_file.data().text(segmentationType);
    const bool fractional = type == "FRACTIONAL";
    m_labelMap = type == "LABELMAP" || m_file.sopClass() == labelMapClass;
    const int bits = m_pixels->bits();
    if (!m_labelMap && bits != 8 && (bits != 1 || fractional))
      return m_file.source().whole(
          "its pixels have " + std::to_string(bits) + " bits; masks have 1 or 8",
          "Export it as a binary segmentation or a label map");
    const std::uint32_t greatest = m_file.data().number(greatestFraction).value_or(255);
    m_inside = fractional ? std::uint16_t(std::clamp((greatest + 1) / 2, 1u, 255u)) : 1;
    m_background = std::uint16_t(m_file.data().number(pixelPadding).value_or(0));
    return std::nullopt;
  }

  /// Reads the values of a frame: 0 outside; 1 inside or, in a label map, the segment's number.
  Status values(std::size_t frame, std::vector<std::uint16_t>& values) const {
    if (!m_options.goesOn())
      return given();
    if (Status status = m_pixels->frame(frame, values); !status)
      return status;
    if (!m_labelMap) {
      for (std::uint16_t& value : values)
        value = value >= m_inside ? 1 : 0;
    } else if (m_background != 0) {
      std::replace(values.begin(), values.end(), m_background, std::uint16_t(0));
    }
    return Unit{};
  }

  /// Determines which slice each frame is.
  std::optional<Error> stack() {
    const FrameAttributes& first = m_frames.front();
    m_normal = glm::cross(first.along, first.down);
    std::set<double> places;
    for (const FrameAttributes& frame : m_frames) {
      const glm::dvec3 way = frame.position - first.position;
      const bool turned =
          glm::dot(frame.along, first.along) < 0.9999 || glm::dot(frame.down, first.down) < 0.9999;
      const bool scaled = std::abs(frame.rowSpacing - first.rowSpacing) > 1e-4 ||
                          std::abs(frame.columnSpacing - first.columnSpacing) > 1e-4;
      const bool aside = std::abs(glm::dot(way, first.along)) > 0.5 * first.columnSpacing ||
                         std::abs(glm::dot(way, first.down)) > 0.5 * first.rowSpacing;
      if (turned || scaled || aside)
        return m_file.source().at("frame " + std::to_string(&frame - m_frames.data() + 1),
                                  "does not lie above the first one on the same grid",
                                  "Export each orientation as a segmentation of its own");
      if (!m_labelMap && !frame.segment)
        return m_file.source().at("frame " + std::to_string(&frame - m_frames.data() + 1),
                                  "does not say which segment it shows",
                                  "Export the segmentation again");
      places.insert(glm::dot(way, m_normal));
    }
    m_low = *places.begin();
    m_spacing = spacingOf(places);
    const double slices = std::round((*places.rbegin() - m_low) / m_spacing) + 1.0;
    if (slices > mostSlicesPerFrame * double(places.size()) + mostSlicesPerFrame)
      return m_file.source().whole(
          "its frames lie too far apart for their spacing of " + std::to_string(m_spacing) + " mm",
          "Export the segmentation again");
    double worst = 0.0;
    for (const double place : places) {
      const double at = (place - m_low) / m_spacing;
      worst = std::max(worst, std::abs(at - std::round(at)) * m_spacing);
    }
    if (worst > 0.1 * m_spacing)
      m_result.warnings.push_back(m_file.source().warning(
          "its slices are not evenly spaced; some moved by " + std::to_string(worst) + " mm"));
    return std::nullopt;
  }

  /// Returns the smallest distance between neighbours, or what the file says where there is but one
  /// slice or only every other slice has a frame.
  double spacingOf(const std::set<double>& places) const {
    const double said = m_frames.front().sliceSpacing;
    double smallest = 0.0;
    const double* before = nullptr;
    for (const double& place : places) {
      const double gap = before ? place - *before : 0.0;
      if (gap > 1e-3 && (smallest == 0.0 || gap < smallest))
        smallest = gap;
      before = &place;
    }
    if (smallest == 0.0)
      return said > 0.0 ? said : 1.0;
    const double ratio = said > 0.0 ? smallest / said : 0.0;
    const bool multiple = ratio > 1.5 && std::abs(ratio - std::round(ratio)) < 0.02;
    return multiple ? said : smallest;
  }

  int sliceOf(const FrameAttributes& frame) const {
    const double place = glm::dot(frame.position - m_frames.front().position, m_normal);
    return int(std::lround((place - m_low) / m_spacing));
  }

  std::optional<Error> measure() {
    std::vector<std::uint16_t> inside;
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
      if (const Status status = values(f, inside); !status)
        return status.error();
      if (m_labelMap)
        for (const std::uint16_t value : inside)
          m_occurs[value] = true;
      const int z = sliceOf(m_frames[f]);
      for (int y = 0; y < m_pixels->rows(); ++y) {
        const auto row = inside.begin() + std::ptrdiff_t(y) * m_pixels->columns();
        const auto end = row + m_pixels->columns();
        const auto first = std::find_if(row, end, [](std::uint16_t value) { return value != 0; });
        if (first == end)
          continue;
        auto last = end;
        while (*(last - 1) == 0)
          --last;
        m_region.low = glm::min(m_region.low, glm::ivec3(first - row, y, z));
        m_region.high = glm::max(m_region.high, glm::ivec3(last - row, y + 1, z + 1));
      }
    }
    return std::nullopt;
  }

  /// Paints segments one after another, each into the first volume in which its voxels are free.
  std::optional<Error> paint() {
    std::map<std::uint32_t, std::vector<std::size_t>> framesOf;
    for (std::size_t f = 0; f < m_frames.size(); ++f)
      framesOf[m_frames[f].segment.value_or(0)].push_back(f);
    if (framesOf.size() > mostLabels)
      return m_file.source().whole("has more than 65,000 segments", "Export fewer segments");
    for (const auto& [number, frames] : framesOf) {
      const auto known = m_segments.find(number);
      if (known == m_segments.end()) {
        m_result.warnings.push_back(
            m_file.source().warning(std::to_string(frames.size()) + " frames belong to segment " +
                                    std::to_string(number) + ", which is not described; left out"));
        continue;
      }
      std::vector<Run> runs;
      if (std::optional<Error> error = collect(frames, runs))
        return error;
      if (runs.empty()) {
        warnEmpty(known->second);
        continue;
      }
      LabelVolume* volume = volumeFor(runs);
      if (!volume)
        return tooLarge();
      volume->labels.push_back(
          {number, known->second.name, known->second.colour, known->second.groups});
      for (const Run& run : runs)
        std::fill_n(volume->voxels.begin() + std::ptrdiff_t(run.begin), run.length,
                    std::uint16_t(volume->labels.size()));
    }
    return std::nullopt;
  }

  void warnEmpty(const Segment& segment) {
    m_result.warnings.push_back(
        m_file.source().warning("\"" + segment.name + "\" has no pixel; left out"));
  }
  Error tooLarge() const {
    return m_file.source().whole("more of its segments overlap than memory allows",
                                 "Export fewer segments at a time");
  }

  /// Paints all segments at once, into one volume.
  std::optional<Error> paintMap() {
    LabelVolume* volume = addVolume();
    if (!volume)
      return tooLarge();
    std::vector<std::uint16_t> labels(pixelValues, 0);
    for (const auto& [number, segment] : m_segments) {
      if (number == m_background || number == 0 || number >= pixelValues)
        continue;
      if (!m_occurs[number]) {
        warnEmpty(segment);
        continue;
      }
      if (volume->labels.size() == mostLabels)
        return m_file.source().whole("has more than 65,000 segments", "Export fewer segments");
      volume->labels.push_back({number, segment.name, segment.colour, segment.groups});
      labels[number] = std::uint16_t(volume->labels.size());
    }
    std::size_t strange = 0;
    for (std::size_t value = 1; value < pixelValues; ++value)
      if (m_occurs[value] && labels[value] == 0)
        ++strange;
    if (strange > 0)
      m_result.warnings.push_back(m_file.source().warning(
          std::to_string(strange) + " of its pixels' values are not described; left out"));
    const glm::ivec3 size = volume->size;
    std::vector<std::uint16_t> pixels;
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
      if (const Status status = values(f, pixels); !status)
        return status.error();
      const int z = sliceOf(m_frames[f]) - m_region.low.z;
      if (z < 0 || z >= size.z)
        continue;  // an empty frame outside the region
      for (int y = 0; y < size.y; ++y) {
        const auto row = pixels.begin() + std::ptrdiff_t(y + m_region.low.y) * m_pixels->columns() +
                         m_region.low.x;
        std::transform(row, row + size.x,
                       volume->voxels.begin() + std::ptrdiff_t(volume->at(0, y, z)),
                       [&](std::uint16_t value) { return labels[value]; });
      }
    }
    return std::nullopt;
  }

  std::optional<Error> collect(const std::vector<std::size_t>& frames,
                               std::vector<Run>& runs) const {
    const glm::ivec3 size = m_region.high - m_region.low;
    std::vector<std::uint16_t> inside;
    for (const std::size_t f : frames) {
      if (const Status status = values(f, inside); !status)
        return status.error();
      const int z = sliceOf(m_frames[f]) - m_region.low.z;
      if (z < 0 || z >= size.z)
        continue;  // an empty frame outside the region
      for (int y = 0; y < size.y; ++y) {
        const auto row = inside.begin() + std::ptrdiff_t(y + m_region.low.y) * m_pixels->columns() +
                         m_region.low.x;
        const auto end = row + size.x;
        const std::size_t first =
            (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
        for (auto at = std::find(row, end, 1); at != end;) {
          const auto stop = std::find(at, end, 0);
          runs.push_back({first + std::size_t(at - row), std::size_t(stop - at)});
          at = std::find(stop, end, 1);
        }
      }
    }
    return std::nullopt;
  }

  /// Returns a volume, or null where there may be no further one.
  LabelVolume* volumeFor(const std::vector<Run>& runs) {
    const auto isFree = [](const LabelVolume& volume, const Run& run) {
      const auto begin = volume.voxels.begin() + std::ptrdiff_t(run.begin);
      const auto end = begin + std::ptrdiff_t(run.length);
      return std::all_of(begin, end, [](std::uint16_t label) { return label == 0; });
    };
    for (LabelVolume& volume : m_result.volumes)
      if (std::all_of(runs.begin(), runs.end(),
                      [&](const Run& run) { return isFree(volume, run); }))
        return &volume;
    return addVolume();
  }

  LabelVolume* addVolume() {
    const glm::ivec3 size = m_region.high - m_region.low;
    const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    if ((m_result.volumes.size() + 1) * std::uint64_t(voxels) >
        mostVoxels + voxelsPerByte * m_file.source().size())
      return nullptr;
    const FrameAttributes& first = m_frames.front();
    const glm::dvec3 columns = first.along * first.columnSpacing;
    const glm::dvec3 rows = first.down * first.rowSpacing;
    const glm::dvec3 slices = m_normal * m_spacing;
    const glm::dvec3 low(m_region.low);
    const glm::dvec3 origin =
        first.position + m_low * m_normal + low.x * columns + low.y * rows + low.z * slices;
    LabelVolume volume;
    volume.size = size;
    volume.voxels.assign(voxels, 0);
    volume.toLps = {glm::dvec4(columns, 0), glm::dvec4(rows, 0), glm::dvec4(slices, 0),
                    glm::dvec4(origin, 1)};
    volume.frame = Frame::lps;
    volume.frameReason = "DICOM: patient coordinates";
    volume.unitReason = "DICOM: millimetres";
    m_result.volumes.push_back(std::move(volume));
    return &m_result.volumes.back();
  }

  const DicomFile& m_file;
  const ReadOptions& m_options;
  std::map<std::uint32_t, Segment> m_segments;
  std::optional<PixelFrames> m_pixels;
  bool m_labelMap = false;
  std::uint16_t m_inside = 1;      ///< values from here on are inside
  std::uint16_t m_background = 0;  ///< in a label map
  std::vector<bool> m_occurs = std::vector<bool>(pixelValues, false);
  std::vector<FrameAttributes> m_frames;
  glm::dvec3 m_normal{0, 0, 1};
  double m_low = 0.0;  ///< lowest slice, in mm from the first frame
  double m_spacing = 1.0;
  Region m_region;
  LabelVolumes m_result;
};

}  // namespace

Result<LabelVolumes> segmentationVolumes(const DicomFile& file, const ReadOptions& options) {
  return SegmentationReader(file, options).read();
}

Result<RawMeshes> segmentationSurfaces(const DicomFile& file, const ReadOptions& options) {
  Result<LabelVolumes> volumes = segmentationVolumes(file, options);
  if (!volumes)
    return volumes.error();
  // A mask of noise has more surface than any organ: the limits of a file grow with its bytes.
  ReadOptions bounded = options;
  const std::uint64_t most = 2'000'000 + 2 * std::uint64_t(file.source().size());
  bounded.limits.vertices = std::min(options.limits.vertices, most);
  bounded.limits.triangles = std::min(options.limits.triangles, 2 * most);
  RawMeshes result;
  result.warnings = std::move(volumes->warnings);
  for (LabelVolume& volume : volumes->volumes) {
    Result<RawMeshes> surfaces = labelSurfaces(volume, bounded);
    if (!surfaces) {
      Error error = surfaces.error();
      error.file = file.source().file();
      return error;
    }
    volume = {};
    for (RawMesh& mesh : surfaces->meshes) {
      mesh.origin = "DICOM segmentation";
      result.meshes.push_back(std::move(mesh));
    }
    std::move(surfaces->warnings.begin(), surfaces->warnings.end(),
              std::back_inserter(result.warnings));
  }
  if (result.meshes.empty())
    return file.source().whole("none of its segments that are described has a pixel",
                               "Export the segmentation again");
  return result;
}

}  // namespace sline::model
