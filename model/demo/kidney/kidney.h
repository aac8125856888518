// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <stop_token>

#include "model/scene/scene.h"

namespace sline::model {

/// A left kidney with its artery, vein and ureter, modelled by the program: four closed surfaces in
/// two groups, patient frame LPS, millimetres, coloured by the anatomist's convention.
/// Throws ModellingStopped where `stop` is asked for on the way.
Scene kidneyDemo(const std::stop_token& stop = {});

/// The left kidney alone, its sinus open: its middle at the origin, 11 cm tall along z, its hilum
/// facing −x. Millimetres, negative inside.
float kidneyField(const glm::vec3& p);

}  // namespace sline::model
