// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/demo/demo_structure.h"

namespace sline::model {

/// Bones, muscles, organs, vessels and nerves of a pelvis and a tumour of its rectum, no patient's
/// but modelled; where two would meet, one has been told to give way to the other.
std::vector<DemoStructure> pelvisStructures(Sex sex);

/// These as a scene, with saved views; takes some seconds.
Scene pelvisDemo(Sex sex);

}  // namespace sline::model
