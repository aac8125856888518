// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// Bones, muscles, organs, vessels and nerves of a pelvis and a tumour of its rectum, no patient's
/// but modelled; where two would meet, one has been told to give way to the other.
std::vector<DemoStructure> pelvisStructures(Sex sex, const std::stop_token& stop = {});

/// These as a scene, with saved views; takes some seconds. Both throw ModellingStopped where `stop`
/// is asked for on the way.
Scene pelvisDemo(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
