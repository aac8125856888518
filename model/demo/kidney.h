// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene/scene.h"

namespace sline::model {

/// A left kidney with its artery, vein and ureter, modelled by the program: four closed surfaces in
/// two groups, patient frame LPS, millimetres, coloured by the anatomist's convention.
Scene kidneyDemo();

}  // namespace sline::model
