// SPDX-License-Identifier: Apache-2.0
// Values of attributes.
#pragma once

#include <string>

#include "model/base/units.h"

namespace sline::render {

/// Rounded to so many decimals, without needless zeros.
std::string number(double value, int decimals);
/// The whole attribute with a space before it; nothing where it is opaque.
std::string opacityAttribute(float opacity);

}  // namespace sline::render
