// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segment_table.h"

#include <glm/mat3x3.hpp>
#include <utility>

#include "model/import/source/colour_of_light.h"

namespace sline::model {

namespace {

constexpr Tag segmentNumber{0x0062, 0x0004};
constexpr Tag segmentLabel{0x0062, 0x0005};
constexpr Tag displayLab{0x0062, 0x000d};
constexpr Tag codeMeaning{0x0008, 0x0104};

/// Returns the meaning of a code sequence's first code; empty without one.
std::string meaningIn(const DataSet& item, Tag sequence) {
  const std::optional<DataSet> code = item.item(sequence);
  return code ? code->utf8(codeMeaning) : std::string();
}

}  // namespace

std::map<std::uint32_t, Segment> segmentsIn(const DicomFile& file) {
  std::map<std::uint32_t, Segment> segments;
  for (const DataSet& item : file.data().items(segmentSequence)) {
    const auto number = item.number(segmentNumber);
    if (!number || segments.contains(*number))
      continue;
    Segment segment;
    segment.name = item.utf8(segmentLabel);
    if (segment.name.empty())
      segment.name = meaningIn(item, propertyType);
    if (segment.name.empty())
      segment.name = "Segment " + std::to_string(*number);
    if (std::string category = meaningIn(item, propertyCategory); !category.empty())
      segment.groups = {std::move(category)};
    if (const auto lab = item.shorts(displayLab); lab.size() == 3)
      segment.colour = colourOfLab({lab[0], lab[1], lab[2]});
    segments[*number] = std::move(segment);
  }
  return segments;
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
  // Converts XYZ under D50 → linear sRGB (Bradford's adaptation to D65 included); columns x, y, z.
  const glm::dmat3 toLinear(3.1338561, -0.9787684, 0.0719453, -1.6168667, 1.9161415, -0.2289914,
                            -0.4906146, 0.0334540, 1.4052427);
  return colourOfLight(toLinear * xyz);
}

}  // namespace sline::model
