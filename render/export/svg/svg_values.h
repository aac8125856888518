// SPDX-License-Identifier: Apache-2.0
// Formats values of attributes.
#pragma once

#include <string>

#include "model/base/units.h"

namespace sline::render {

/// Returns the value rounded to so many decimals, without needless zeros.
std::string number(double value, int decimals);
/// Returns the whole attribute with a space before it; nothing where it is opaque.
std::string opacityAttribute(float opacity);

}  // namespace sline::render
