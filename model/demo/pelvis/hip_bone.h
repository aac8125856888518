// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/sculpting/sculpture.h"

namespace sline::model {

/// The middle of the left hip joint, mm in the pelvis demo's frame (LPS): of the femoral head and
/// of the cup that holds it.
inline constexpr glm::vec3 leftHipJoint{94.0f, -88.0f, 880.0f};

/// Models the left hip bone of a man: a curved wing with crest and spines, the cup for the femoral
/// head, the pubic rami and the ischium around the obturator foramen.
Sculpture leftHipBone();

}  // namespace sline::model
