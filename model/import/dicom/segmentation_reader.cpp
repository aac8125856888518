// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segmentation_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

namespace sline::model {

namespace {

/// So many slices may lie between the first and the last for each that has a frame.
constexpr double mostSlicesPerFrame = 8.0;
constexpr Tag segmentationType{0x0062, 0x0001};
constexpr Tag greatestFraction{0x0062, 0x000e};
constexpr Tag pixelPadding{0x0028, 0x0120};

}  // namespace

Result<LabelVolumes> SegmentationReader::read() {
  m_segments = segmentsIn(m_file);
  m_pixels = TRY(PixelFrames::open(m_file));
  if (std::optional<Error> error = readType())
    return *error;
  m_frames = TRY(frameAttributesIn(m_file));
  if (m_frames.size() != m_pixels->frames() || m_frames.empty())
    return m_file.source().whole("has " + std::to_string(m_pixels->frames()) +
                                     " frames but tells where " + std::to_string(m_frames.size()) +
                                     " of them lie",
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

std::optional<Error> SegmentationReader::readType() {
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

Status SegmentationReader::values(std::size_t frame, std::vector<std::uint16_t>& values) const {
  if (!m_options.goesOn())
    return given();
  TRY(m_pixels->frame(frame, values));
  if (!m_labelMap) {
    for (std::uint16_t& value : values)
      value = value >= m_inside ? 1 : 0;
  } else if (m_background != 0) {
    std::replace(values.begin(), values.end(), m_background, std::uint16_t(0));
  }
  return Unit{};
}

std::optional<Error> SegmentationReader::stack() {
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

double SegmentationReader::spacingOf(const std::set<double>& places) const {
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

int SegmentationReader::sliceOf(const FrameAttributes& frame) const {
  const double place = glm::dot(frame.position - m_frames.front().position, m_normal);
  return int(std::lround((place - m_low) / m_spacing));
}

std::optional<Error> SegmentationReader::measure() {
  std::vector<std::uint16_t> inside;
  for (std::size_t f = 0; f < m_frames.size(); ++f) {
    // Most masks have many frames without anything, one after the other.
    if (f > 0 && m_pixels->packedAlike(f - 1, f)) {
      if (!m_options.goesOn())
        return given();
    } else if (const Status status = values(f, inside); !status) {
      return status.error();
    }
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

}  // namespace sline::model
