// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// Models the bones, muscles, organs, vessels and nerves of a pelvis and a tumour of its rectum;
/// they are no patient's. Where two would meet, one of them gives way to the other.
std::vector<DemoStructure> pelvisStructures(Sex sex, const std::stop_token& stop = {});

/// Returns these structures as a scene with saved views; it takes some seconds. Both functions
/// throw ModellingStopped if `stop` is requested on the way.
Scene pelvisDemo(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
