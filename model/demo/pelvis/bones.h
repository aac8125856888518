// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <vector>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// The midline of the pelvis demo is the plane at this x (mm, LPS).
inline constexpr float pelvisMiddle = -0.8f;

/// Returns the point in a man's pelvis, for which all shapes are modelled, that corresponds to a
/// point in a woman's, so that a man's field read there is the woman's: her inlet is wider, the
/// pubic arch opens wider and the sacrum is shorter and broader. The map is smooth and one to one.
glm::vec3 fromFemalePelvis(const glm::vec3& p);
/// Returns the inverse map, to within a hundredth of a millimetre.
glm::vec3 toFemalePelvis(const glm::vec3& p);

/// Models hip bones, sacrum with coccyx, fifth lumbar vertebra, the disc below it, upper ends of
/// the femora and the disc of the pubic symphysis. No two overlap. Throws ModellingStopped if
/// `stop` is requested on the way.
std::vector<DemoStructure> pelvisBones(Sex sex, const std::stop_token& stop = {});

}  // namespace sline::model
