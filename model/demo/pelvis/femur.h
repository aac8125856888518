// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/sculpting/sculpture.h"

namespace sline::model {

/// Models the upper end of a man's left femur, cut across below the lesser trochanter; its head
/// fills the hip joint (see leftHipJoint). Pelvis demo's frame, LPS, mm.
Sculpture leftFemur();

}  // namespace sline::model
