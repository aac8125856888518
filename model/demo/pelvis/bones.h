// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// The midline of the pelvis demo is the plane x = this (mm, LPS).
inline constexpr float pelvisMiddle = -0.8f;

/// Where a point of a woman's pelvis lies in the man's that all shapes are modelled for, so that
/// the field of a man's structure read there is the woman's: her inlet is wider, the pubic arch
/// opens wider and the sacrum is shorter and broader. Smooth, and one to one.
glm::vec3 fromFemalePelvis(const glm::vec3& p);
/// The way back, to within a hundredth of a millimetre.
glm::vec3 toFemalePelvis(const glm::vec3& p);

/// Hip bones, sacrum with coccyx, fifth lumbar vertebra, the disc below it, upper ends of the
/// femora and the disc of the pubic symphysis. No two overlap. Throws ModellingStopped where `stop`
/// is asked for on the way.
std::vector<DemoStructure> pelvisBones(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
