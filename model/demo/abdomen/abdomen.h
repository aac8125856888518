// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// The structures of the demo abdomen before they are meshed.
std::vector<DemoStructure> abdomenStructures(Sex sex);

/// The organs of the abdomen before the lumbar column, modelled by the program: some fifty closed
/// surfaces in groups by system, patient frame LPS, millimetres. No organ here differs between the
/// sexes in kind; the female body is the male one at 0.93 of its size, the ratio of mean statures.
/// What is in focus is shaded, vessels are hatched, bowel, bones and muscles are drawn in few
/// lines. Saved views: "Overview", "From the left", "From behind", and cut open "Transpyloric
/// plane" and "Sagittal through the aorta". Throws ModellingStopped where `stop` is
/// asked for on the way.
Scene abdomenDemo(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
