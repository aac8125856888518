// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// Returns the structures of the demo abdomen before they are meshed.
std::vector<DemoStructure> abdomenStructures(Sex sex);

/// Models the organs of the abdomen in front of the lumbar column: some fifty closed surfaces in
/// groups by system, patient frame LPS, millimetres. No organ here differs between the sexes in
/// kind; the female body is the male one at 0.93 of its size, the ratio of mean statures.
/// Structures in focus are shaded, vessels are hatched, bowel, bones and muscles are drawn in few
/// lines. Saved views: "Overview", "From the left", "From behind", and cut open "Transpyloric
/// plane" and "Sagittal through the aorta". Throws ModellingStopped if `stop` is requested on the
/// way.
Scene abdomenDemo(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
