// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/frame_attributes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {

constexpr Tag imagePosition{0x0020, 0x0032};
constexpr Tag imageOrientation{0x0020, 0x0037};
constexpr Tag pixelSpacing{0x0028, 0x0030};
constexpr Tag sliceThickness{0x0018, 0x0050};
constexpr Tag spacingBetween{0x0018, 0x0088};
constexpr Tag rescaleIntercept{0x0028, 0x1052};
constexpr Tag rescaleSlope{0x0028, 0x1053};
constexpr Tag rescaleType{0x0028, 0x1054};
constexpr Tag referencedSegment{0x0062, 0x000b};
/// No patient lies farther from the scanner's origin, mm.
constexpr double farthest = 1e5;
constexpr double greatestValue = 1e9;

bool within(const std::vector<double>& values, double limit) {
  return std::all_of(values.begin(), values.end(),
                     [&](double value) { return std::abs(value) <= limit; });
}

/// Collects what the parts of a data set say; values that a part leaves open stay.
class PlaceReader {
 public:
  void readGroups(const DataSet& groups) {
    const auto part = [&](Tag tag, void (PlaceReader::*read)(const DataSet&)) {
      if (const std::optional<DataSet> item = groups.item(tag))
        (this->*read)(*item);
    };
    part(positionGroup, &PlaceReader::readPosition);
    part(orientationGroup, &PlaceReader::readOrientation);
    part(measuresGroup, &PlaceReader::readMeasures);
    part(rescaleGroup, &PlaceReader::readRescale);
    part(segmentGroup, &PlaceReader::readSegment);
  }
  void readImage(const DataSet& image) {
    readPosition(image);
    readOrientation(image);
    readMeasures(image);
    readRescale(image);
  }
  const FrameAttributes& place() const { return m_place; }
  /// Returns what is missing, as the continuation of a sentence; null where nothing is.
  const char* missing() const {
    return !m_position      ? "where it lies"
           : !m_orientation ? "how it is turned"
           : !m_spacing     ? "how far apart its pixels are"
                            : nullptr;
  }

 private:
  void readPosition(const DataSet& item) {
    const auto p = item.decimals(imagePosition, 3);
    if (!p || !within(*p, farthest))
      return;
    m_place.position = {(*p)[0], (*p)[1], (*p)[2]};
    m_position = true;
  }
  void readOrientation(const DataSet& item) {
    const auto o = item.decimals(imageOrientation, 6);
    if (!o || !within(*o, 1.01))
      return;
    const glm::dvec3 along((*o)[0], (*o)[1], (*o)[2]);
    const glm::dvec3 down((*o)[3], (*o)[4], (*o)[5]);
    const bool upright = std::abs(glm::length(along) - 1.0) < 0.01 &&
                         std::abs(glm::length(down) - 1.0) < 0.01 &&
                         std::abs(glm::dot(along, down)) < 0.01;
    if (!upright)
      return;
    m_place.along = glm::normalize(along);
    m_place.down = glm::normalize(down);
    m_orientation = true;
  }
  void readMeasures(const DataSet& item) {
    const auto spacing = item.decimals(pixelSpacing, 2);
    const auto sound = [](double mm) { return mm >= 1e-3 && mm <= 1e3; };
    if (!spacing || !sound((*spacing)[0]) || !sound((*spacing)[1]))
      return;
    m_place.rowSpacing = (*spacing)[0];
    m_place.columnSpacing = (*spacing)[1];
    for (const Tag tag : {spacingBetween, sliceThickness})
      if (const auto mm = item.decimal(tag); mm && sound(std::abs(*mm))) {
        m_place.sliceSpacing = std::abs(*mm);
        break;
      }
    m_spacing = true;
  }
  void readRescale(const DataSet& item) {
    const auto slope = item.decimal(rescaleSlope);
    const auto intercept = item.decimal(rescaleIntercept);
    if (slope && intercept && *slope != 0.0 && within({*slope, *intercept}, greatestValue)) {
      m_place.slope = *slope;
      m_place.intercept = *intercept;
    }
    if (std::string unit = item.text(rescaleType); !unit.empty())
      m_place.unit = std::move(unit);
  }
  void readSegment(const DataSet& item) {
    if (const auto number = item.number(referencedSegment))
      m_place.segment = *number;
  }

  FrameAttributes m_place;
  bool m_position = false;
  bool m_orientation = false;
  bool m_spacing = false;
};

}  // namespace

Result<std::vector<FrameAttributes>> frameAttributesIn(const DicomFile& file) {
  std::vector<PlaceReader> readers;
  if (file.data().has(frameGroups)) {
    PlaceReader shared;
    if (const std::optional<DataSet> groups = file.data().item(sharedGroups))
      shared.readGroups(*groups);
    for (const DataSet& groups : file.data().items(frameGroups)) {
      readers.push_back(shared);
      readers.back().readGroups(groups);
    }
  } else {
    readers.emplace_back();
    readers.back().readImage(file.data());
  }
  std::vector<FrameAttributes> frames;
  for (const PlaceReader& reader : readers) {
    if (const char* missing = reader.missing())
      return file.source().at("frame " + std::to_string(frames.size() + 1),
                              std::string("does not say ") + missing,
                              "Export the images again, with their places in the patient");
    frames.push_back(reader.place());
  }
  return frames;
}

}  // namespace sline::model
