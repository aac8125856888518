// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <stop_token>

#include "model/scene/scene.h"

namespace sline::model {

/// Models a left kidney with its artery, vein and ureter: four closed surfaces in two groups,
/// patient frame LPS, millimetres, coloured by the anatomist's convention. Throws ModellingStopped
/// if `stop` is requested on the way.
Scene kidneyDemo(const std::stop_token& stop = {});

/// Returns the field of the left kidney alone with its sinus open: its middle at the origin, 11 cm
/// tall along z, its hilum facing −x. Millimetres, negative inside.
float kidneyField(const glm::vec3& p);

}  // namespace sline::model
