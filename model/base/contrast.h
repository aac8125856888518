// SPDX-License-Identifier: Apache-2.0
// Measures and makes contrast, as the Web Content Accessibility Guidelines 2.2 define it (§1.4.3).
#pragma once

#include "model/base/units.h"

namespace sline {

/// Returns the relative luminance, 0 for black to 1 for white.
double luminanceOf(const Colour& colour);
/// Returns how much the colours differ in luminance, 1 for none to 21 for black on white.
double contrastBetween(const Colour& a, const Colour& b);
/// Returns the colour itself where its contrast to the ground is at least `ratio`, else the colour
/// darkened (on a light ground) or lightened (on a dark one) just as far as needed. Its hue stays
/// while it darkens.
Colour legibleOn(const Colour& ground, const Colour& colour, double ratio);

}  // namespace sline
