// SPDX-License-Identifier: Apache-2.0
// The rules of what one sees, each written once: shaders include the files of rules/, and C++ has
// the same functions from here. Such a file keeps to what GLSL 3.30, GLSL ES 3.00 and C++ with GLM
// have in common: functions of numbers and vectors without state, marked RULE; numbers end with f,
// no swizzles, no names of either language. Wide loops call them with single numbers.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define RULE [[gnu::always_inline]] inline
namespace sline::render::rule {
using namespace glm;
#include "render/sight/rules/depth.glsl"
#include "render/sight/rules/shade.glsl"
}  // namespace sline::render::rule
#undef RULE
