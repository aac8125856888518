// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/frame_and_unit.h"

#include <algorithm>
#include <glm/common.hpp>

#include "model/anatomy/body_systems.h"
#include "model/import/naming/laterality.h"

namespace sline::model {

namespace {

Box boxOf(const std::vector<glm::vec3>& positions) {
  Box box;
  for (const glm::vec3& p : positions)
    box.add(p);
  return box;
}

/// Sets the length of a part's unit, from what its file says, and where it says so.
void ownUnit(Part& part, const ImportOptions& options, bool ofSlicer) {
  std::string& reason = part.provenance.unitReason;
  part.unit = part.frame == Frame::file ? 1.0f : part.raw.millimetresPerUnit;
  if (part.frame == Frame::file) {
    const bool told = !part.raw.unitReason.empty() && part.raw.millimetresPerUnit == 1.0f;
    reason = told ? part.raw.unitReason : "coordinates left as they are";
  } else if (part.choice.unit || options.unit) {
    part.unit = part.choice.unit ? *part.choice.unit : *options.unit;
    reason = "chosen by the user";
  } else if (!part.raw.unitReason.empty()) {
    reason = part.raw.unitReason;
  } else {
    reason = ofSlicer ? "scene of Slicer: millimetres" : "no unit in the file: millimetres assumed";
  }
}

}  // namespace

void decideUnits(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                 ImportReport& report) {
  constexpr float smallestScene = 3.0f;
  const AnatomyTable table;
  Box box;
  bool anatomical = false;
  const auto ofSlicer = [&](const Part& part) {
    return sources.files[part.file].model.has_value();
  };
  const auto unitless = [&](const Part& part) {
    return !options.unit && !part.choice.unit && part.raw.unitReason.empty() &&
           part.frame != Frame::file && !ofSlicer(part);
  };
  for (Part& part : parts) {
    ownUnit(part, options, ofSlicer(part));
    if (!unitless(part))
      continue;
    box.add(boxOf(part.raw.positions));
    anatomical = anatomical || table.match(part.name).has_value();
  }
  if (box.empty() || !anatomical)
    return;
  const glm::vec3 size = box.size();
  const float extent = std::max({size.x, size.y, size.z});
  if (!(extent < smallestScene))
    return;
  const std::string found =
      "everything together is only " + std::to_string(extent) + " units large";
  for (Part& part : parts)
    if (unitless(part)) {
      part.unit = 1000.0f;
      part.provenance.unitReason = found + ": metres";
    }
  report.warnings.push_back({"", found + "; the unit was taken as the metre (times 1000)"});
}

}  // namespace sline::model
