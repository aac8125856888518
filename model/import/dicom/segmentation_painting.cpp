// SPDX-License-Identifier: Apache-2.0
// Paints the segments of a segmentation into volumes of labels.
#include <algorithm>
#include <string>
#include <utility>

#include "model/import/dicom/segmentation_reader.h"

namespace sline::model {

namespace {

constexpr std::size_t mostLabels = 65'000;

/// Volumes of segments that overlap may have this many voxels together, and so many more for each
/// byte of the file.
constexpr std::uint64_t mostVoxels = std::uint64_t(128) << 20;
constexpr std::uint64_t voxelsPerByte = 64;

}  // namespace

std::optional<Error> SegmentationReader::paint() {
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

void SegmentationReader::warnEmpty(const Segment& segment) {
  m_result.warnings.push_back(
      m_file.source().warning("\"" + segment.name + "\" has no pixel; left out"));
}

Error SegmentationReader::tooLarge() const {
  return m_file.source().whole("more of its segments overlap than memory allows",
                               "Export fewer segments at a time");
}

std::optional<Error> SegmentationReader::paintMap() {
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
    TRY(values(f, pixels));
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

std::optional<Error> SegmentationReader::collect(const std::vector<std::size_t>& frames,
                                                 std::vector<Run>& runs) const {
  const glm::ivec3 size = m_region.high - m_region.low;
  std::vector<std::uint16_t> inside;
  for (const std::size_t f : frames) {
    TRY(values(f, inside));
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

LabelVolume* SegmentationReader::volumeFor(const std::vector<Run>& runs) {
  const auto isFree = [](const LabelVolume& volume, const Run& run) {
    const auto begin = volume.voxels.begin() + std::ptrdiff_t(run.begin);
    const auto end = begin + std::ptrdiff_t(run.length);
    return std::all_of(begin, end, [](std::uint16_t label) { return label == 0; });
  };
  for (LabelVolume& volume : m_result.volumes)
    if (std::all_of(runs.begin(), runs.end(), [&](const Run& run) { return isFree(volume, run); }))
      return &volume;
  return addVolume();
}

LabelVolume* SegmentationReader::addVolume() {
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
  volume.unitReason = dicomUnit;
  m_result.volumes.push_back(std::move(volume));
  return &m_result.volumes.back();
}

}  // namespace sline::model
