// SPDX-License-Identifier: Apache-2.0
// The rules of what one sees, each written once: shaders include the files of rules/, and C++ has
// the same functions from here. Such a file keeps to what GLSL 3.30, GLSL ES 3.00 and C++ with GLM
// have in common: functions of numbers and vectors without state, marked RULE, and of
// numbers marked CONSTANT; numbers end with f, no swizzles, no names of either language. What is
// written for NUMBER works on lanes, too.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/base/lanes.h"

#define RULE [[gnu::always_inline]] inline
#define CONSTANT inline constexpr
namespace sline::render::rule {
using glm::abs, glm::clamp, glm::dot, glm::floor, glm::fract, glm::max, glm::min, glm::mix,
    glm::smoothstep, glm::sqrt, glm::vec2, glm::vec3, glm::vec4;
#define NUMBER float
#include "render/sight/rules/cuts.glsl"
#include "render/sight/rules/depth.glsl"
#include "render/sight/rules/grain.glsl"
#include "render/sight/rules/layers.glsl"
#include "render/sight/rules/pen.glsl"
#include "render/sight/rules/shade.glsl"
#include "render/sight/rules/sight.glsl"
#undef NUMBER
}  // namespace sline::render::rule

/// The rules that wide loops call with several numbers at once.
namespace sline::render::wide_rule {
RULE Lanes max(Lanes x, float least) {
  return larger(x, Lanes{} + least);
}
RULE Lanes min(Lanes x, float most) {
  return smaller(x, Lanes{} + most);
}
RULE Lanes clamp(Lanes x, float least, float most) {
  return min(max(x, least), most);
}
#define NUMBER Lanes
#define NUMBER_IS_WIDE
#include "render/sight/rules/layers.glsl"
#include "render/sight/rules/pen.glsl"
#undef NUMBER_IS_WIDE
#undef NUMBER
}  // namespace sline::render::wide_rule
#undef CONSTANT
#undef RULE
