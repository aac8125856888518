// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segment_table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace sline::model {

namespace {

constexpr Tag segmentSequence{0x0062, 0x0002};
constexpr Tag propertyCategory{0x0062, 0x0003};
constexpr Tag segmentNumber{0x0062, 0x0004};
constexpr Tag segmentLabel{0x0062, 0x0005};
constexpr Tag displayLab{0x0062, 0x000d};
constexpr Tag propertyType{0x0062, 0x000f};
constexpr Tag codeMeaning{0x0008, 0x0104};
constexpr Tag sharedGroups{0x5200, 0x9229};
constexpr Tag frameGroups{0x5200, 0x9230};
constexpr Tag positionGroup{0x0020, 0x9113};
constexpr Tag orientationGroup{0x0020, 0x9116};
constexpr Tag measuresGroup{0x0028, 0x9110};
constexpr Tag segmentGroup{0x0062, 0x000a};
constexpr Tag imagePosition{0x0020, 0x0032};
constexpr Tag imageOrientation{0x0020, 0x0037};
constexpr Tag pixelSpacing{0x0028, 0x0030};
constexpr Tag sliceThickness{0x0018, 0x0050};
constexpr Tag spacingBetween{0x0018, 0x0088};
constexpr Tag referencedSegment{0x0062, 0x000b};
constexpr double farthest = 1e5;

std::uint8_t encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return std::uint8_t(std::lround(255.0 * y));
}

bool within(const std::vector<double>& values, double limit) {
  return std::all_of(values.begin(), values.end(),
                     [&](double value) { return std::abs(value) <= limit; });
}

/// What one item of functional groups says; what it leaves open stays.
class GroupReader {
 public:
  struct Found {
    FramePlace place;
    bool segment = false;
    bool position = false;
    bool orientation = false;
    bool spacing = false;
    bool whole() const { return segment && position && orientation && spacing; }
  };

  static std::optional<Error> read(const DataSet& groups, Found& found) {
    const auto sub = [&](Tag tag, auto&& use) -> std::optional<Error> {
      const Result<std::optional<DataSet>> item = groups.item(tag);
      if (!item)
        return item.error();
      if (*item)
        use(**item, found);
      return std::nullopt;
    };
    if (auto error = sub(positionGroup, readPosition))
      return error;
    if (auto error = sub(orientationGroup, readOrientation))
      return error;
    if (auto error = sub(measuresGroup, readMeasures))
      return error;
    return sub(segmentGroup, readSegment);
  }

 private:
  static void readPosition(const DataSet& item, Found& found) {
    const auto p = item.decimals(imagePosition);
    if (!p || p->size() != 3 || !within(*p, farthest))
      return;
    found.place.position = {(*p)[0], (*p)[1], (*p)[2]};
    found.position = true;
  }
  static void readOrientation(const DataSet& item, Found& found) {
    const auto o = item.decimals(imageOrientation);
    if (!o || o->size() != 6 || !within(*o, 1.01))
      return;
    const glm::dvec3 along((*o)[0], (*o)[1], (*o)[2]);
    const glm::dvec3 down((*o)[3], (*o)[4], (*o)[5]);
    const bool upright = std::abs(glm::length(along) - 1.0) < 0.01 &&
                         std::abs(glm::length(down) - 1.0) < 0.01 &&
                         std::abs(glm::dot(along, down)) < 0.01;
    if (!upright)
      return;
    found.place.along = glm::normalize(along);
    found.place.down = glm::normalize(down);
    found.orientation = true;
  }
  static void readMeasures(const DataSet& item, Found& found) {
    const auto spacing = item.decimals(pixelSpacing);
    const auto sound = [](double mm) { return mm >= 1e-3 && mm <= 1e3; };
    if (!spacing || spacing->size() != 2 || !sound((*spacing)[0]) || !sound((*spacing)[1]))
      return;
    found.place.rowSpacing = (*spacing)[0];
    found.place.columnSpacing = (*spacing)[1];
    for (const Tag tag : {spacingBetween, sliceThickness})
      if (const auto mm = item.decimals(tag); mm && sound(std::abs(mm->front()))) {
        found.place.sliceSpacing = std::abs(mm->front());
        break;
      }
    found.spacing = true;
  }
  static void readSegment(const DataSet& item, Found& found) {
    if (const auto number = item.number(referencedSegment)) {
      found.place.segment = *number;
      found.segment = true;
    }
  }
};

}  // namespace

Result<std::map<std::uint32_t, Segment>> segmentsIn(const DicomFile& file) {
  std::map<std::uint32_t, Segment> segments;
  const Result<std::vector<DataSet>> items = file.data().items(segmentSequence);
  if (!items)
    return items.error();
  for (const DataSet& item : *items) {
    const auto number = item.number(segmentNumber);
    if (!number || segments.contains(*number))
      continue;
    const Result<std::optional<DataSet>> type = item.item(propertyType);
    const Result<std::optional<DataSet>> category = item.item(propertyCategory);
    if (!type || !category)
      return !type ? type.error() : category.error();
    Segment segment;
    segment.name = file.utf8(item.text(segmentLabel));
    if (segment.name.empty() && *type)
      segment.name = file.utf8((*type)->text(codeMeaning));
    if (segment.name.empty())
      segment.name = "Segment " + std::to_string(*number);
    if (*category && !(*category)->text(codeMeaning).empty())
      segment.groups = {file.utf8((*category)->text(codeMeaning))};
    if (const auto lab = item.shorts(displayLab); lab.size() == 3)
      segment.colour = colourOfLab({lab[0], lab[1], lab[2]});
    segments[*number] = std::move(segment);
  }
  return segments;
}

Result<std::vector<FramePlace>> framesIn(const DicomFile& file) {
  GroupReader::Found shared;
  const Result<std::optional<DataSet>> sharedItem = file.data().item(sharedGroups);
  if (!sharedItem)
    return sharedItem.error();
  if (*sharedItem)
    if (std::optional<Error> error = GroupReader::read(**sharedItem, shared))
      return *error;
  const Result<std::vector<DataSet>> items = file.data().items(frameGroups);
  if (!items)
    return items.error();
  std::vector<FramePlace> frames;
  for (const DataSet& item : *items) {
    GroupReader::Found found = shared;
    if (std::optional<Error> error = GroupReader::read(item, found))
      return *error;
    if (!found.whole())
      return file.source().at(
          "frame " + std::to_string(frames.size() + 1),
          std::string("does not say ") + (!found.segment       ? "which segment it shows"
                                          : !found.position    ? "where it lies"
                                          : !found.orientation ? "how it is turned"
                                                               : "how far apart its pixels are"),
          "Export the segmentation again");
    frames.push_back(found.place);
  }
  return frames;
}

Colour colourOfLab(const std::array<std::uint16_t, 3>& lab) {
  const double light = 100.0 * lab[0] / 65535.0;
  const double a = 255.0 * lab[1] / 65535.0 - 128.0;
  const double b = 255.0 * lab[2] / 65535.0 - 128.0;
  const double y = (light + 16.0) / 116.0;
  const auto inverse = [](double t) {
    return t > 6.0 / 29.0 ? t * t * t : 3.0 * (6.0 / 29.0) * (6.0 / 29.0) * (t - 4.0 / 29.0);
  };
  const glm::dvec3 xyz(0.9642 * inverse(y + a / 500.0), inverse(y),
                       0.8249 * inverse(y - b / 200.0));
  // XYZ under D50 → linear sRGB (Bradford's adaptation to D65 included); columns x, y, z.
  const glm::dmat3 toLinear(3.1338561, -0.9787684, 0.0719453, -1.6168667, 1.9161415, -0.2289914,
                            -0.4906146, 0.0334540, 1.4052427);
  const glm::dvec3 rgb = toLinear * xyz;
  return {encoded(rgb.x), encoded(rgb.y), encoded(rgb.z)};
}

}  // namespace sline::model
